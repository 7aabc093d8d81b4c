// Writes the time shown and the speed in words.

import { formatFixed, significant } from "../format/numbers";
import { formatDuration } from "../format/times";
import { say, words } from "../words/words";

/** The time (s) in a motion: 0.3214 s of 3 s. */
export function timeText(time: number, end: number): string {
  return say(words.transport.of, {
    time: `${formatFixed(time, 4)} s`,
    end: `${significant(end, 4)} s`,
  });
}

/** The time (s) relative to a collision (s): 12.3 µs before the collision. */
export function collisionText(time: number, collision: number | undefined): string {
  if (collision === undefined) return "";
  const since = time - collision;
  if (since === 0) return words.transport.atCollision;
  return say(words.transport.fromCollision, {
    time: formatDuration(Math.abs(since)),
    when: since < 0 ? "before" : "after",
  });
}

/** The speed compared with real time. */
export function slowdownText(slowdown: number): string {
  if (slowdown < 1.005) return words.transport.inRealTime;
  return say(words.transport.slower, { times: significant(slowdown, 2) });
}
