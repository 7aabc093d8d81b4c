// How time goes by as a motion is shown. The motion does not depend on it, but a link holds it.

import { noSuchChoice } from "./choices";
import type { Refusal } from "./setup";

export const SPEEDS = [1, 0.5, 0.2, 0.1, 0.02, 0.01, 0.001, 0.0001] as const;

/** As a visitor reads it. */
export const speedName = (speed: number) =>
  speed === 1 ? "real time" : `1/${Math.round(1 / speed)}`;

export interface Pace {
  /** Seconds of the motion in one of the visitor's. */
  speed: number;
  /** Whether time stretches by itself at the collision. */
  stretched: boolean;
}

export const INITIAL_PACE: Readonly<Pace> = Object.freeze({ speed: 1, stretched: true });

/** In the URL. */
export type PaceName = "speed" | "slow";

/** What differs from the initial pace, as pairs of name and value. */
export function paceInLink({ speed, stretched }: Readonly<Pace>): [PaceName, string][] {
  const pairs: [PaceName, string][] = [];
  if (speed !== INITIAL_PACE.speed) pairs.push(["speed", String(speed)]);
  if (stretched !== INITIAL_PACE.stretched) pairs.push(["slow", stretched ? "1" : "0"]);
  return pairs;
}

/** The pace that a link holds; what it holds wrongly is as initially, with the reason. */
export function paceOf(link: ReadonlyMap<string, string>): { pace: Pace; refusals: Refusal[] } {
  const pace = { ...INITIAL_PACE };
  const refusals: Refusal[] = [];
  const [speed, slow] = [link.get("speed"), link.get("slow")];
  const one = SPEEDS.find((each) => String(each) === speed);
  if (one !== undefined) pace.speed = one;
  else if (speed !== undefined)
    refusals.push(refused("speed", "Speed", SPEEDS.map(speedName), speed));
  if (slow === "0" || slow === "1") pace.stretched = slow === "1";
  else if (slow !== undefined)
    refusals.push(refused("slow", "Slow at the collision", ["on", "off"], slow));
  return { pace, refusals };
}

const refused = (
  field: PaceName,
  label: string,
  names: readonly string[],
  text: string,
): Refusal => ({ field, text, message: noSuchChoice(label, names, text) });
