// Numbers that say how far the model holds for a motion: those of its near-collision, compared with what a
// real rim and a real table are like.

import type { Motion } from "../core/motion";
import type { Body } from "../core/core";
import type { Passage } from "../verdict/passage";

/** Height of the roughness of rims and tables, m: pressed metal and varnished wood, roughly. */
export const ROUGHNESS = [1e-6, 1e-5] as const;
/** Speed of sound in steel, aluminium and glass, m/s: each between 5 and 6 km/s. */
export const SOUND = 5000;

export interface Numbers {
  /** Height of the highest point of the rim at the smallest tilt, m. */
  gap: number;
  /** Speed of the contact point along the rim then, m/s. */
  speed: number;
  /** Time in which the contact point runs through most of its angle, s. */
  passage: number;
  /** Time in which sound crosses the base, s. */
  crossing: number;
  /** Largest normal force of the turn over the weight. */
  force: number;
  /** Energy lost in the turn over the largest kinetic energy in it. */
  loss: number;
}

export function numbersOf(
  motion: Motion,
  { minTilt, yawRate, fastTime, start, end }: Passage,
  { mass, radius }: Body,
  gravity: number,
): Numbers {
  const moments = motion.samples(1);
  const t = moments.column("t");
  const largest = (of: Float64Array) => {
    let most = 0;
    for (let k = 0; k < t.length; k++)
      if (t[k]! >= start && t[k]! <= end) most = Math.max(most, of[k]!);
    return most;
  };
  const [before, after] = [start, end].map((time) => {
    const moment = motion.at([time]).moment(0);
    return moment.friction_loss + moment.resistance_loss + moment.impact_loss;
  }) as [number, number];
  const kinetic = largest(moments.column("kinetic_energy"));
  return {
    gap: 2 * radius * Math.sin(minTilt),
    speed: radius * Math.abs(yawRate),
    passage: fastTime,
    crossing: (2 * radius) / SOUND,
    force: largest(moments.column("normal_force")) / (mass * gravity),
    loss: kinetic > 0 ? (after - before) / kinetic : 0,
  };
}
