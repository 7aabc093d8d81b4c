// Writes the time shown and the speed in words.

import { significant } from "../format/numbers";
import { formatDuration } from "../format/times";

/** The time (s) in a motion: 0.3214 s of 3 s. */
export function timeText(time: number, end: number): string {
  return `${time.toFixed(4)} s of ${significant(end, 4)} s`;
}

/** The time (s) relative to a collision (s): 12.3 µs before the collision. */
export function collisionText(time: number, collision: number | undefined): string {
  if (collision === undefined) return "";
  const since = time - collision;
  if (since === 0) return "at the collision";
  return `${formatDuration(Math.abs(since))} ${since < 0 ? "before" : "after"} the collision`;
}

/** The speed compared with real time. */
export function slowdownText(slowdown: number): string {
  if (slowdown < 1.005) return "in real time";
  return `${significant(slowdown, 2)} times slower than real time`;
}
