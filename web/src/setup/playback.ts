// How fast a motion is played and from where it is seen. The motion does not depend on it, but a link holds it.

import type { PlaybackName, Refusal } from "./fields";
import { choiceOf, say, words } from "../words/words";

export const SPEEDS = [1, 0.5, 0.2, 0.1, 0.02, 0.01, 0.001, 0.0001] as const;

/** The speed as a visitor reads it. */
export const speedName = (speed: number) =>
  speed === 1 ? words.playback.realTime : `1/${Math.round(1 / speed)}`;

/** Places of the camera; from the last two the body is transparent. */
export const VIEWS = ["whole", "above", "contact", "below"] as const;
export type ViewName = (typeof VIEWS)[number];

export interface Playback {
  /** Seconds of the motion per second of the visitor. */
  speed: number;
  /** Whether time stretches automatically at the collision. */
  stretched: boolean;
  view: ViewName;
}

export const INITIAL_PLAYBACK: Readonly<Playback> = Object.freeze({
  speed: 1,
  stretched: true,
  view: "whole",
});

/** The settings that differ from the initial ones, as pairs of name and value. */
export function playbackInLink(playback: Readonly<Playback>): [PlaybackName, string][] {
  const { speed, stretched, view } = playback;
  const pairs: [PlaybackName, string][] = [];
  if (speed !== INITIAL_PLAYBACK.speed) pairs.push(["speed", String(speed)]);
  if (stretched !== INITIAL_PLAYBACK.stretched) pairs.push(["slow", stretched ? "1" : "0"]);
  if (view !== INITIAL_PLAYBACK.view) pairs.push(["view", view]);
  return pairs;
}

/** The playback settings in a link; a wrong value gives the initial one and a refusal. */
export function playbackFrom(link: ReadonlyMap<string, string>): {
  playback: Playback;
  refusals: Refusal[];
} {
  const playback = { ...INITIAL_PLAYBACK };
  const refusals: Refusal[] = [];
  const [speed, slow, view] = [link.get("speed"), link.get("slow"), link.get("view")];
  const known = SPEEDS.find((each) => String(each) === speed);
  if (known !== undefined) playback.speed = known;
  else if (speed !== undefined)
    refusals.push(refused("speed", words.playback.speed, SPEEDS.map(speedName), speed));
  if (slow === "0" || slow === "1") playback.stretched = slow === "1";
  else if (slow !== undefined)
    refusals.push(
      refused("slow", words.playback.slow, [words.playback.on, words.playback.off], slow),
    );
  const place = VIEWS.find((each) => each === view);
  if (place !== undefined) playback.view = place;
  else if (view !== undefined) refusals.push(refused("view", words.playback.view, VIEWS, view));
  return { playback, refusals };
}

const refused = (
  field: PlaybackName,
  label: string,
  names: readonly string[],
  text: string,
): Refusal => ({
  field,
  text,
  message: say(words.refusals.noSuchChoice, { label, ...choiceOf(names), text }),
});
