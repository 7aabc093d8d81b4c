// Writes the time shown and the speed in words.

import { formatFixed, significant } from "../format/numbers";
import { formatDuration } from "../format/times";
import { words } from "../words/words";

/** The time (s) in a motion: 0.3214 s of 3 s. */
export function timeText(time: number, end: number): string {
  return words.transport.of(`${formatFixed(time, 4)} s`, `${significant(end, 4)} s`);
}

/** The time (s) relative to a collision (s): 12.3 µs before the collision. */
export function collisionText(time: number, collision: number | undefined): string {
  if (collision === undefined) return "";
  const since = time - collision;
  if (since === 0) return words.transport.atCollision;
  return words.transport.fromCollision(
    formatDuration(Math.abs(since)),
    since < 0 ? "before" : "after",
  );
}

/** The speed compared with real time. */
export function slowdownText(slowdown: number): string {
  if (slowdown < 1.005) return words.transport.inRealTime;
  return words.transport.slower(significant(slowdown, 2));
}
