// The set-up that results when a hand lets the body go, in the units of the fields.

import { HAND_ERROR, type Setup } from "./setup";

const DEGREES = 180 / Math.PI;
/** A hand slower than this counts as at rest, rad/s. */
const AT_REST = 0.12;
/** Largest rate of a flick, rad/s. */
const MAX_RATE = 25;
/** Largest sideways error of a hand that lets go at rest, rad/s. */
const MAX_SIDEWAYS = 0.05;

/** How a hand holds the body: tilt and yaw, rad. */
export interface Held {
  tilt: number;
  yaw: number;
}

/** The lean of the body as a vector on the table, whose length is the tilt in rad; or the rate of change
 * of that vector, rad/s. */
export interface Lean {
  x: number;
  y: number;
}

/** The rate of a hand at rest, rad/s. */
export const ZERO_RATE: Readonly<Lean> = { x: 0, y: 0 };

/** Tilt and yaw of a held body, in the units of the fields. */
export function leanFields(held: Held): Pick<Setup, "tilt" | "yaw"> {
  return {
    tilt: rounded(held.tilt * DEGREES, 10),
    yaw: rounded(within(held.yaw * DEGREES), 10),
  };
}

/** The fields that change when the hand lets go while its lean changes at a rate (rad/s). */
export function releasedSetup(held: Held, rate: Lean, setup: Readonly<Setup>): Partial<Setup> {
  const { tilt, yaw } = leanFields(held);
  const error = Math.abs(setup.sideways) <= MAX_SIDEWAYS ? setup.sideways : HAND_ERROR;
  if (Math.hypot(rate.x, rate.y) < AT_REST)
    return { tilt, yaw, tilt_rate: 0, twist: 0, sideways: error };
  const [c, s] = [-Math.cos(held.yaw), -Math.sin(held.yaw)];
  const along = rate.x * c + rate.y * s;
  // The hand swings the lean round without turning the body about the vertical: the body turns about
  // the line along which it leans.
  const across = ((rate.y * c - rate.x * s) * Math.tan(held.tilt)) / held.tilt;
  const aside = rounded(limited(across), 1000);
  return {
    tilt,
    yaw,
    tilt_rate: rounded(limited(along), 100),
    twist: 0,
    sideways: aside === 0 ? error : aside,
  };
}

const limited = (rate: number) => Math.min(Math.max(rate, -MAX_RATE), MAX_RATE);
const rounded = (value: number, times: number) => Math.round(value * times) / times || 0;
/** The same direction between −180 (included) and 180 degrees. */
const within = (degrees: number) => degrees - 360 * Math.floor((degrees + 180) / 360);
