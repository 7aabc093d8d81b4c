// Colours of the laws, which colour-blind readers can distinguish (Okabe and Ito).

export const LAW_COLOURS = {
  no_slip: "var(--law-no_slip)",
  frictionless: "var(--law-frictionless)",
} as const;
