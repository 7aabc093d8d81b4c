// Writes the set-up into the part of the address after #, which links hold and servers do not see.

import { FIELD_NAMES } from "./fields";
import { INITIAL_PLAYBACK, type Playback, playbackInLink, playbackFrom } from "./playback";
import type { Refusal } from "./refusal";
import { INITIAL, type Setup, read } from "./setup";

/** The content of a link. */
export interface Linked {
  setup: Setup;
  playback: Playback;
  refusals: Refusal[];
}

/** The values that differ from the initial set-up and playback, as `name=value&…`. */
export function toHash(
  setup: Readonly<Setup>,
  playback: Readonly<Playback> = INITIAL_PLAYBACK,
): string {
  const changed = FIELD_NAMES.filter((name) => setup[name] !== INITIAL[name]);
  const pairs = changed.map((name) => [name, String(setup[name])]);
  return new URLSearchParams([...pairs, ...playbackInLink(playback)]).toString();
}

/** Whether the # part of an address holds a set-up and not the name of a part of the page. */
export const holdsSetup = (hash: string): boolean =>
  hash.length <= 1 || hash.includes("=") || hash === "#embed" || hash === "#lab";

/** Reads a link. A wrong value gives the initial one and a refusal; if a name appears twice, the last
 * value counts. */
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
