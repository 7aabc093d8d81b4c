// The star: the path of the rate across the axis, in the body's frame. A fall is a ray to the middle and out again;
// each near-collision turns the ray by the angle of turn less a half turn.

import type { Motion } from "../core/motion";
import { type Rates, bodyRates } from "./rates";

/** Half the size of the picture. */
export const SIZE = 100;
/** Radius of the longest ray in the picture. */
const LONGEST = 84;
/** No more points than this are drawn. */
const MOST_POINTS = 3000;

export interface Star {
  /** Path of an SVG about the middle. */
  path: string;
  /** The rate that the outer circle stands for, rad/s. */
  largest: number;
  /** A place in the picture for rates along x and y, rad/s. */
  place(x: number, y: number): [x: number, y: number];
}

/** The star of a motion up to a time (s). */
export function starOf(motion: Motion, until: number): Star {
  const moments = motion.curve();
  const t = moments.column("t");
  const rates = bodyRates(moments);
  const largest = roundUp(largestOf(rates));
  const place = (x: number, y: number): [number, number] => [
    (LONGEST * x) / largest,
    (-LONGEST * y) / largest,
  ];
  const every = Math.max(1, Math.ceil(t.length / MOST_POINTS));
  const points: string[] = [];
  for (let k = 0; k < t.length && t[k]! <= until; k += every) {
    const [x, y] = place(rates.x[k]!, rates.y[k]!);
    points.push(`${x.toFixed(1)} ${y.toFixed(1)}`);
  }
  return { path: points.length > 0 ? `M${points.join("L")}` : "", largest, place };
}

function largestOf({ x, y }: Rates): number {
  let largest = 0;
  for (let k = 0; k < x.length; k++) largest = Math.max(largest, Math.hypot(x[k]!, y[k]!));
  return largest;
}

/** The next larger round number. */
function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return (
    [1, 1.5, 2, 3, 4, 6, 8, 10].map((times) => times * power).find((one) => one >= value) ?? value
  );
}
