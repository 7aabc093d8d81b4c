// The body comes down, its contact point races, and it rises again: what is to be said about that.

import { type Motion, headingOf } from "../core/motion";

export interface Passage {
  /** Angle of turn, rad; as far as it came, if the motion ends on the way up. */
  angle: number;
  /** How far the body itself turned about its axis meanwhile, rad. */
  own: number;
  /** Whether it came up to a largest tilt again. */
  whole: boolean;
  /** When that begins and ends, s. */
  start: number;
  end: number;
  minTilt: number;
  /** rad/s, at the smallest tilt */
  yawRate: number;
  /** From a tenth to nine tenths of the angle, s. */
  fastTime: number;
  /** What the rim does on the way: it only rolls, or slips at times, or even leaves the table. */
  rim: "rolled" | "slipped" | "jumped";
}

/** The one that begins at a time; none if the body does not come down after it. */
export function passageFrom(motion: Motion, start: number): Passage | undefined {
  const turn = motion.turns.find((turn) => turn.start === start);
  const lowest =
    turn ??
    motion.events
      .filter(({ kind, moment }) => kind === "tilt_min" && moment.t > start)
      .map(({ moment }) => ({ t: moment.t, minTilt: moment.tilt, yawRate: moment.yaw_rate }))[0];
  if (!lowest) return undefined;
  const end = turn?.end ?? motion.end;
  const yawAt = (time: number) => motion.at([time]).moment(0).yaw;
  const headingAt = (time: number) => headingOf(motion.at([time]).moment(0));
  const from = yawAt(start);
  const angle = turn?.angle ?? yawAt(end) - from;
  const crosses = (part: number) => (time: number) => (yawAt(time) - from) / angle >= part;
  const begun = firstTime(crosses(0.1), start, lowest.t);
  const done = firstTime(crosses(0.9), lowest.t, end);
  const met = (kind: string) =>
    motion.phases.some((phase) => phase.kind === kind && phase.start < end && phase.end > start);
  return {
    angle,
    own: headingAt(end) - headingAt(start),
    whole: turn !== undefined,
    start,
    end,
    minTilt: lowest.minTilt,
    yawRate: lowest.yawRate,
    fastTime: done - begun,
    rim: met("flying") ? "jumped" : met("sliding") ? "slipped" : "rolled",
  };
}

/** When it comes true, by halving. */
function firstTime(isTrue: (time: number) => boolean, low: number, high: number): number {
  for (let k = 0; k < 60; k++) {
    const middle = (low + high) / 2;
    if (isTrue(middle)) high = middle;
    else low = middle;
  }
  return high;
}
