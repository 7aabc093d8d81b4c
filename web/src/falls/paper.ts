// Measurements of the paper.

/** Mean turn and standard deviation of each side, degrees, for 42 flicks of the paper's can (Srinivasan
 * & Ruina 2007), of which as many are taken to have fallen to the left as to the right. */
export const MEASURED = {
  left: { mean: 213.0, deviation: 3.9, count: 21 },
  right: { mean: 217.9, deviation: 4.5, count: 21 },
} as const;
