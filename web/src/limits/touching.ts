// How long a base is nearer to the table than their unevenness.

import type { Motion } from "../core/motion";

export interface Touching {
  /** s */
  time: number;
  /** Angle through which the contact point runs meanwhile, rad. */
  angle: number;
}

/** The part of a motion from `start` to `end` (s) during which the highest point of the rim, whose radius is in m, is lower than a
 * unevenness (m). Undefined if there is none. */
export function touching(
  motion: Motion,
  { start, end }: { start: number; end: number },
  radius: number,
  unevenness: number,
): Touching | undefined {
  const moments = motion.curve();
  const [t, tilt, yaw] = [moments.column("t"), moments.column("tilt"), moments.column("yaw")];
  let [time, angle] = [0, 0];
  for (let k = 1; k < moments.length; k++) {
    const [from, to] = [t[k - 1]!, t[k]!];
    const inside = Math.min(to, end) - Math.max(from, start);
    if (inside <= 0) continue;
    const low = partBelow(tilt[k - 1]!, tilt[k]!, unevenness / (2 * radius));
    const part = low * (inside / (to - from));
    time += part * (to - from);
    angle += part * Math.abs(yaw[k]! - yaw[k - 1]!);
  }
  return time > 0 ? { time, angle } : undefined;
}

/** The part of a straight line between two values that is below a limit. */
function partBelow(a: number, b: number, limit: number): number {
  const [low, high] = [Math.min(a, b), Math.max(a, b)];
  if (high <= limit) return 1;
  return low >= limit ? 0 : (limit - low) / (high - low);
}
