// The star: the path of the rate across the axis, in the body's frame. A fall is a ray to the middle and out again;
// each near-collision turns the ray by the angle of turn less a half turn.

import type { Moments, Motion } from "../core/motion";
import { countBelow } from "../rising";
import { bodyRatesIn } from "./rates";

/** Half the size of the picture. */
export const SIZE = 100;
/** Radius of the longest ray in the picture. */
const LONGEST = 84;
/** No more points than this are drawn. */
const MOST_POINTS = 3000;

/** The star of a motion. */
export class Star {
  /** The rate that the outer circle stands for, rad/s. */
  readonly largest: number;
  private readonly times: number[] = [];
  private readonly points: string[] = [];

  constructor(motion: Motion) {
    const moments = motion.curve();
    this.largest = roundUp(largestOf(moments));
    const every = Math.max(1, Math.ceil(moments.length / MOST_POINTS));
    const [times, rates] = [moments.column("t"), bodyRatesIn(moments)];
    for (let k = 0; k < moments.length; k += every) {
      const { x, y } = rates(k);
      this.times.push(times[k]!);
      this.points.push(
        this.place(x, y)
          .map((at) => at.toFixed(1))
          .join(" "),
      );
    }
  }

  /** A place in the picture for rates along x and y, rad/s. */
  place(x: number, y: number): [x: number, y: number] {
    return [(LONGEST * x) / this.largest, (-LONGEST * y) / this.largest];
  }

  /** The path up to a time (s) about the middle of an SVG. */
  path(until = Infinity): string {
    const points = this.points.slice(0, countBelow(this.times, until));
    return points.length > 0 ? `M${points.join("L")}` : "";
  }
}

/** The largest rate across the axis, rad/s. */
function largestOf(moments: Moments): number {
  const [tilt, tiltRate] = [moments.column("tilt"), moments.column("tilt_rate")];
  const yawRate = moments.column("yaw_rate");
  let largest = 0;
  for (let k = 0; k < moments.length; k++)
    largest = Math.max(largest, Math.hypot(yawRate[k]! * Math.sin(tilt[k]!), tiltRate[k]!));
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
