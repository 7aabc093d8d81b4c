// How fast a motion is played. The motion does not depend on it, but a link holds it.

import type { PlaybackName } from "./fields";
import { type Refusal, noSuchChoice } from "./refusal";

export const SPEEDS = [1, 0.5, 0.2, 0.1, 0.02, 0.01, 0.001, 0.0001] as const;

/** The speed as a visitor reads it. */
export const speedName = (speed: number) =>
  speed === 1 ? "real time" : `1/${Math.round(1 / speed)}`;

export interface Playback {
  /** Seconds of the motion per second of the visitor. */
  speed: number;
  /** Whether time stretches automatically at the collision. */
  stretched: boolean;
}

export const INITIAL_PLAYBACK: Readonly<Playback> = Object.freeze({ speed: 1, stretched: true });

/** The settings that differ from the initial ones, as pairs of name and value. */
export function playbackInLink({ speed, stretched }: Readonly<Playback>): [PlaybackName, string][] {
  const pairs: [PlaybackName, string][] = [];
  if (speed !== INITIAL_PLAYBACK.speed) pairs.push(["speed", String(speed)]);
  if (stretched !== INITIAL_PLAYBACK.stretched) pairs.push(["slow", stretched ? "1" : "0"]);
  return pairs;
}

/** The playback settings in a link; a wrong value gives the initial one and a refusal. */
export function playbackFrom(link: ReadonlyMap<string, string>): {
  playback: Playback;
  refusals: Refusal[];
} {
  const playback = { ...INITIAL_PLAYBACK };
  const refusals: Refusal[] = [];
  const [speed, slow] = [link.get("speed"), link.get("slow")];
  const known = SPEEDS.find((each) => String(each) === speed);
  if (known !== undefined) playback.speed = known;
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
