// The whole set-up in the part of the address after #, so that a link holds it and no server sees it.

import { FIELD_NAMES } from "./fields";
import { INITIAL_PLAYBACK, type Playback, playbackInLink, playbackFrom } from "./playback";
import type { Refusal } from "./refusal";
import { INITIAL, type Setup, read } from "./setup";

/** What a link holds. */
export interface Linked {
  setup: Setup;
  playback: Playback;
  refusals: Refusal[];
}

/** What differs from the initial set-up and playback, as `name=value&…`. */
export function toHash(
  setup: Readonly<Setup>,
  playback: Readonly<Playback> = INITIAL_PLAYBACK,
): string {
  const changed = FIELD_NAMES.filter((name) => setup[name] !== INITIAL[name]);
  const pairs = changed.map((name) => [name, String(setup[name])]);
  return new URLSearchParams([...pairs, ...playbackInLink(playback)]).toString();
}

/** Whether an address is about a set-up, and not about a part of the page. */
export const holdsSetup = (hash: string): boolean => hash.length <= 1 || hash.includes("=");

/** What a link holds wrongly stays as it is initially, with the reason; of what it holds twice the
 * last counts. */
export function fromHash(hash: string): Linked {
  const link = new Map(new URLSearchParams(hash.replace(/^#/, "")));
  const setup: Record<string, string | number> = { ...INITIAL };
  const { playback, refusals } = playbackFrom(link);
  for (const name of FIELD_NAMES) {
    const text = link.get(name);
    if (text === undefined) continue;
    const result = read(name, text);
    if ("value" in result) setup[name] = result.value;
    else refusals.push(result);
  }
  return { setup: setup as unknown as Setup, playback, refusals };
}
