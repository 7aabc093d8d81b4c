// Colours of the laws, told apart whatever the reader's colour vision (Okabe and Ito).

export const LAW_COLOURS = {
  no_slip: "var(--no-slip, #0072b2)",
  frictionless: "var(--frictionless, #d55e00)",
} as const;
