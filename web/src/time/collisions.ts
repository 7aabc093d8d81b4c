// The collisions and near-collisions of a motion.

import type { Motion } from "../core/motion";

export interface Collision {
  /** s */
  t: number;
  /** Approximate duration, s: the time of half a revolution at the yaw rate of its middle. */
  duration: number;
}

// Events at which the base comes near the table or meets it.
const COLLISIONS = new Set(["tilt_min", "land", "face_down", "topple"]);

/** The collisions in the order of time. */
export function collisionsOf(motion: Motion): Collision[] {
  return motion.events
    .filter((event) => COLLISIONS.has(event.kind))
    .map(({ moment: { t, yaw_rate } }) => ({
      t,
      duration: Math.min(Math.PI / Math.abs(yaw_rate), motion.end / 10),
    }));
}

/** Index of the collision nearest to a time (s), or -1 if there is none. */
export function nearest(collisions: readonly Collision[], time: number): number {
  const distance = (index: number) => Math.abs((collisions[index]?.t ?? Infinity) - time);
  let best = collisions.length - 1;
  for (let k = best; k-- > 0;) if (distance(k) <= distance(best)) best = k;
  return best;
}
