// Where the second body is drawn.

import { type Size, reachOf } from "../scene/bodies/shapes";

/** Bodies whose sizes differ by more than this factor stand side by side: the smaller one would vanish inside the
 * larger one. */
const ALIKE = 1.5;
/** Distance between bodies side by side, in radii of the circle of degrees; the two circles do not meet. */
const APART = 2.3;
/** To the right in the initial view. */
const RIGHT = [0.978, 0.209] as const;

export interface Layout {
  /** Place of B on the table, in radii of the circle of degrees of A. */
  offset: { x: number; y: number };
  /** Length that is drawn as long as the radius of the circle of degrees, m. */
  reach: number;
  /** How many times larger than A it is drawn. */
  times: number;
}

/** A ghost at the place of A and to its scale if the bodies are about as large, else beside it and as large. */
export function layoutOf(a: Size, b: Size): Layout {
  const [mine, other] = [reachOf(a), reachOf(b)];
  const ratio = mine / other;
  if (Math.max(ratio, 1 / ratio) <= ALIKE) return { offset: { x: 0, y: 0 }, reach: mine, times: 1 };
  return { offset: { x: APART * RIGHT[0], y: APART * RIGHT[1] }, reach: other, times: ratio };
}

export const isBeside = ({ offset }: Layout): boolean => offset.x !== 0 || offset.y !== 0;
