// What the paper measured.

/** The paper's can, 42 flicks: mean turn and standard deviation of each side, degrees (Srinivasan & Ruina
 * 2007). */
export const MEASURED = {
  left: { mean: 213.0, deviation: 3.9 },
  right: { mean: 217.9, deviation: 4.5 },
} as const;
