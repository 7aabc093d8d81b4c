// What is compared of two motions, in numbers.

import type { Motion } from "../core/motion";
import type { Outcome } from "../simulation";
import { passageFrom } from "../verdict/passage";

/** Numbers of one motion, of its first turn unless they say otherwise; NaN where it has none. */
export interface Numbers {
  /** Angle through which the contact point ran round, rad. */
  turn: number;
  /** Rotation of the body itself in that direction, rad. */
  itself: number;
  /** Limiting turn on this table, rad. */
  limit: number;
  /** Smallest tilt, rad. */
  tilt: number;
  /** Gap under the highest point of the rim then, m. */
  gap: number;
  /** Time of the smallest tilt, s. */
  time: number;
  /** Time for most of the angle, s. */
  passage: number;
  /** Largest normal force over the weight. */
  force: number;
  /** Energy at the end of the turn over that at the start. Zero is the body flat at rest. */
  energy: number;
  /** End of the motion, s. */
  end: number;
}

export function numbersOf(outcome: Outcome | undefined): Numbers | undefined {
  if (!outcome || !("motion" in outcome)) return undefined;
  const { motion, theory, input } = outcome;
  const passage = passageFrom(motion, 0);
  const lowest = motion.turns[0]?.t ?? firstLowest(motion);
  return {
    turn: Math.abs(passage?.angle ?? NaN),
    itself: passage ? passage.bodyAngle * (Math.sign(passage.angle) || 1) : NaN,
    limit: theory.here,
    tilt: passage?.minTilt ?? NaN,
    gap: passage?.validity.gap ?? NaN,
    time: lowest,
    passage: passage?.validity.passageTime ?? NaN,
    force: passage?.validity.forceRatio ?? NaN,
    energy: input.shaking ? NaN : energyKept(motion, passage?.end ?? motion.end),
    end: motion.end,
  };
}

const firstLowest = (motion: Motion) =>
  motion.events.find(({ kind }) => kind === "tilt_min")?.moment.t ?? NaN;

/** Part of the energy that is left at a time (s); the core counts it from the body flat at rest. */
function energyKept(motion: Motion, time: number): number {
  const [before, after] = [0, time].map((t) => {
    const { kinetic_energy, potential_energy } = motion.at([t]).moment(0);
    return kinetic_energy + potential_energy;
  }) as [number, number];
  return before > 0 ? after / before : NaN;
}
