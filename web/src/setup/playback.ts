// How time goes by as a motion is shown. The motion does not depend on it, but a link holds it.

import type { PlaybackName } from "./fields";
import { type Refusal, noSuchChoice } from "./refusal";

export const SPEEDS = [1, 0.5, 0.2, 0.1, 0.02, 0.01, 0.001, 0.0001] as const;

/** As a visitor reads it. */
export const speedName = (speed: number) =>
  speed === 1 ? "real time" : `1/${Math.round(1 / speed)}`;

export interface Playback {
  /** Seconds of the motion in one of the visitor's. */
  speed: number;
  /** Whether time stretches by itself at the collision. */
  stretched: boolean;
}

export const INITIAL_PLAYBACK: Readonly<Playback> = Object.freeze({ speed: 1, stretched: true });

/** What differs from the initial playback, as pairs of name and value. */
export function playbackInLink({ speed, stretched }: Readonly<Playback>): [PlaybackName, string][] {
  const pairs: [PlaybackName, string][] = [];
  if (speed !== INITIAL_PLAYBACK.speed) pairs.push(["speed", String(speed)]);
  if (stretched !== INITIAL_PLAYBACK.stretched) pairs.push(["slow", stretched ? "1" : "0"]);
  return pairs;
}

/** The playback that a link holds; what it holds wrongly is as initially, with the reason. */
export function playbackFrom(link: ReadonlyMap<string, string>): {
  playback: Playback;
  refusals: Refusal[];
} {
  const playback = { ...INITIAL_PLAYBACK };
  const refusals: Refusal[] = [];
  const [speed, slow] = [link.get("speed"), link.get("slow")];
  const one = SPEEDS.find((each) => String(each) === speed);
  if (one !== undefined) playback.speed = one;
  else if (speed !== undefined)
    refusals.push(refused("speed", "Speed", SPEEDS.map(speedName), speed));
  if (slow === "0" || slow === "1") playback.stretched = slow === "1";
  else if (slow !== undefined)
    refusals.push(refused("slow", "Slow at the collision", ["on", "off"], slow));
  return { playback, refusals };
}

const refused = (
  field: PlaybackName,
  label: string,
  names: readonly string[],
  text: string,
): Refusal => ({ field, text, message: noSuchChoice(label, names, text) });
