// Colours of the laws, told apart whatever the reader's colour vision (Okabe and Ito).

export const LAW_COLOURS = {
  no_slip: "var(--law-no_slip)",
  frictionless: "var(--law-frictionless)",
} as const;
