// The yaw at the solver steps and between them.

import type { Moments } from "./motion";

/** Times (s) and yaws (rad). */
export interface Yaws {
  t: Float64Array;
  yaw: Float64Array;
}

/** Each solver step is divided into this many parts, so that the yaw rate hardly changes in one. */
const PARTS = 4;

/** Yaws at the solver steps and between them, by cubic Hermite interpolation. To request as many moments from the core takes a
 * hundred times as long. */
export function yawsOf(steps: Moments): Yaws {
  const [times, yaws, rates] = [steps.column("t"), steps.column("yaw"), steps.column("yaw_rate")];
  const length = PARTS * (times.length - 1) + 1;
  const [t, yaw] = [new Float64Array(length), new Float64Array(length)];
  t[0] = at(times, 0);
  yaw[0] = at(yaws, 0);
  for (let k = 1, n = 1; k < times.length; k++) {
    const [from, to] = [at(times, k - 1), at(times, k)];
    const [start, rise] = [at(yaws, k - 1), at(yaws, k) - at(yaws, k - 1)];
    const [first, last] = [at(rates, k - 1) * (to - from), at(rates, k) * (to - from)];
    for (let part = 1; part < PARTS; part++, n++) {
      const s = part / PARTS;
      t[n] = from + s * (to - from);
      yaw[n] =
        start + s * (first + s * (3 * rise - 2 * first - last + s * (first + last - 2 * rise)));
    }
    t[n] = to;
    yaw[n++] = at(yaws, k);
  }
  return { t, yaw };
}

const at = (array: Float64Array, index: number) => array[index] as number;
