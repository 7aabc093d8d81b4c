// The gap between rim and table, and how much it is magnified in the picture. Lengths are in m.

import type { Pose } from "./pose";

/** Number of marks on the rim. */
export const MARKS = 24;

/** The smallest gap of a turn is drawn about as high as this, in radii of the rim. */
const HEIGHT = 0.5;
/** A gap that would be drawn higher fades, and is not drawn from twice this height on. */
const HIGHEST = 1.2;

/** Height of the highest point of the rim over the table. */
export const gapOf = ({ tilt, z }: Pick<Pose, "tilt" | "z">, radius: number): number =>
  z + radius * Math.sin(tilt);

/** The magnification, 1, 2 or 5 times a power of ten, for a turn with a smallest tilt (rad). */
export function magnification(minTilt: number | undefined, radius: number): number {
  const smallest = 2 * radius * Math.sin(minTilt ?? NaN);
  if (!(smallest > 0)) return 1;
  const times = (HEIGHT * radius) / smallest;
  const ten = 10 ** Math.floor(Math.log10(times));
  const round = [5, 2, 1].find((one) => one * ten <= times) ?? 1;
  return Math.max(round * ten, 1);
}

/** Opacity of a gap that is drawn with a height. */
export const fadeOf = (height: number, radius: number): number =>
  Math.min(Math.max(2 - height / (HIGHEST * radius), 0), 1);
