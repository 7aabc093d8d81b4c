// Measurements of the paper.

/** Mean turn and standard deviation of each side, degrees, for 42 flicks of the paper's can (Srinivasan
 * & Ruina 2007). */
export const MEASURED = {
  left: { mean: 213.0, deviation: 3.9 },
  right: { mean: 217.9, deviation: 4.5 },
} as const;
