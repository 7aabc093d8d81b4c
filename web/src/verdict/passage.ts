// The passage of a body through a near-collision: it comes down, its contact point races, it rises again.

import { computed, type ReadonlySignal } from "@preact/signals-core";
import { headingOf, type Motion, type Validity } from "../core/motion";
import type { Lab } from "../lab";

export interface Passage {
  /** Angle of turn, rad; up to the end of the motion if that comes first. */
  angle: number;
  /** Rotation of the body itself about its axis meanwhile, rad. */
  bodyAngle: number;
  /** Whether it ends with a tilt maximum. */
  complete: boolean;
  /** Start and end, s. */
  start: number;
  end: number;
  minTilt: number;
  /** rad/s, at the smallest tilt */
  yawRate: number;
  /** How far the model holds meanwhile. */
  validity: Validity;
  /** Whether the rim only rolls, slips at times, or leaves the table at times. */
  rim: "rolled" | "slipped" | "jumped";
}

/** The passage of the turn that is shown. */
export function shownPassage(lab: Lab): ReadonlySignal<Passage | undefined> {
  const start = computed(() => lab.turnProgress.value?.start);
  return computed(() => {
    const motion = lab.motion.value;
    return motion && start.value !== undefined ? passageFrom(motion, start.value) : undefined;
  });
}

/** The passage that starts at a time (s); undefined if the body does not come down after it. */
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
  const startYaw = yawAt(start);
  const angle = turn?.angle ?? yawAt(end) - startYaw;
  const includes = (kind: string) =>
    motion.phases.some((phase) => phase.kind === kind && phase.start < end && phase.end > start);
  return {
    angle,
    bodyAngle: headingAt(end) - headingAt(start),
    complete: turn !== undefined,
    start,
    end,
    minTilt: lowest.minTilt,
    yawRate: lowest.yawRate,
    validity: motion.validity(start, lowest.t, end),
    rim: includes("flying") ? "jumped" : includes("sliding") ? "slipped" : "rolled",
  };
}
