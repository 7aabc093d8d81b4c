// The body comes down, its contact point races, and it rises again: what is to be said about that.

import type { Motion } from "../core/motion";

export interface Passage {
  /** Angle of turn, rad; as far as it came, if the motion ends on the way. */
  angle: number;
  /** Whether it came up to a largest tilt again. */
  whole: boolean;
  minTilt: number;
  /** rad/s, at the smallest tilt */
  yawRate: number;
  /** From a tenth to nine tenths of the angle, s. */
  swiftness: number;
  /** Whether the rim slipped on its way from the one to the other. */
  slipped: boolean;
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
  const samples = motion.samples(4);
  const [times, yaws] = [samples.column("t"), samples.column("yaw")];
  const from = motion.at([start]).moment(0).yaw;
  const angle = turn?.angle ?? motion.at([end]).moment(0).yaw - from;
  const crossing = (part: number) => {
    const k = times.findIndex((t, k) => t >= start && ((yaws[k] ?? 0) - from) / angle >= part);
    const [t0, t1] = [times[k - 1] ?? start, times[k] ?? end];
    const [y0, y1] = [yaws[k - 1] ?? from, yaws[k] ?? from + angle];
    return y1 === y0 ? t1 : t0 + ((from + part * angle - y0) / (y1 - y0)) * (t1 - t0);
  };
  const [begun, done] = [crossing(0.1), crossing(0.9)];
  const slides = (p: { kind: string; start: number; end: number }) =>
    p.kind === "sliding" && p.start < done && p.end > begun;
  return {
    angle,
    whole: turn !== undefined,
    minTilt: lowest.minTilt,
    yawRate: lowest.yawRate,
    swiftness: done - begun,
    slipped: motion.phases.some(slides),
  };
}
