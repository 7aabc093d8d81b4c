// When a motion gets interesting: its collisions, nearly or quite.

import type { Motion } from "../core/motion";

export interface Collision {
  /** s */
  t: number;
  /** About how long it lasts, s: as long as half a turn at the rate of its middle. */
  duration: number;
}

// The base comes near the table, or meets it.
const COLLISIONS = new Set(["tilt_min", "land", "face_down", "topple"]);

/** In the order of time. */
export function collisionsOf(motion: Motion): Collision[] {
  return motion.events
    .filter((event) => COLLISIONS.has(event.kind))
    .map(({ moment: { t, yaw_rate } }) => ({
      t,
      duration: Math.min(Math.PI / Math.abs(yaw_rate), motion.end / 10),
    }));
}

/** Which collision is the nearest to a time; -1 where there is none. */
export function nearest(collisions: readonly Collision[], time: number): number {
  const away = (index: number) => Math.abs((collisions[index]?.t ?? Infinity) - time);
  let best = collisions.length - 1;
  for (let k = best; k-- > 0;) if (away(k) <= away(best)) best = k;
  return best;
}
