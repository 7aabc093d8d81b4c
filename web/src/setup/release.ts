// What a hand that holds the body lets go, in the units of the fields.

import { FIELDS } from "./fields";
import type { Setup } from "./setup";

const DEGREES = 180 / Math.PI;
/** A hand slower than this is at rest, rad/s. */
const AT_REST = 0.12;
/** Faster than this no hand flicks, rad/s. */
const FASTEST = 25;
/** A hand that lets go at rest errs sideways by no more, rad/s. */
const STEADY = 0.05;

/** How a hand holds the body: its lean in rad. */
export interface Held {
  tilt: number;
  yaw: number;
}

/** How far the body leans, and whereto: the tilt, rad, as an arrow on the table; or how fast that
 * changes. */
export interface Lean {
  x: number;
  y: number;
}

/** The rate of a hand at rest. */
export const ZERO_RATE: Readonly<Lean> = { x: 0, y: 0 };

/** How a body that is held leans, in the units of the fields. */
export function leanFields(held: Held): Pick<Setup, "tilt" | "yaw"> {
  return {
    tilt: rounded(held.tilt * DEGREES, 10),
    yaw: rounded(within(held.yaw * DEGREES), 10),
  };
}

/** What of the set-up is new when the hand lets go, moving at a rate (rad/s). */
export function releasedSetup(held: Held, rate: Lean, setup: Readonly<Setup>): Partial<Setup> {
  const { tilt, yaw } = leanFields(held);
  const human = Math.abs(setup.sideways) <= STEADY ? setup.sideways : FIELDS.sideways.initial;
  if (Math.hypot(rate.x, rate.y) < AT_REST)
    return { tilt, yaw, tilt_rate: 0, twist: 0, sideways: human };
  const [c, s] = [-Math.cos(held.yaw), -Math.sin(held.yaw)];
  const along = rate.x * c + rate.y * s;
  // A lean led round, without turning the body about the vertical: it turns about the line along
  // which it leans.
  const across = ((rate.y * c - rate.x * s) * Math.tan(held.tilt)) / held.tilt;
  const aside = rounded(limited(across), 1000);
  return {
    tilt,
    yaw,
    tilt_rate: rounded(limited(along), 100),
    twist: 0,
    sideways: aside === 0 ? human : aside,
  };
}

const limited = (rate: number) => Math.min(Math.max(rate, -FASTEST), FASTEST);
const rounded = (value: number, times: number) => Math.round(value * times) / times || 0;
/** The same direction from −180 up to 180 degrees. */
const within = (degrees: number) => degrees - 360 * Math.floor((degrees + 180) / 360);
