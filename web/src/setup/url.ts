// Writes the set-up into the part of the address after #, which links hold and servers do not see.

import { FIELD_NAMES, type FieldName, MOTION_FIELDS, OTHER, type Refusal } from "./fields";
import { INITIAL_PLAYBACK, type Playback, playbackFrom, playbackInLink } from "./playback";
import { BY_HAND, INITIAL, read, type Setup } from "./setup";
import { say, words } from "../words/words";

/** The content of a link. */
export interface Linked {
  setup: Setup;
  playback: Playback;
  /** The set-up that it is compared with. */
  other: Setup | undefined;
  refusals: Refusal[];
}

/** A link to a set-up, without the #; empty for what the lab opens with. */
export function toHash(
  setup: Readonly<Setup>,
  playback: Readonly<Playback> = INITIAL_PLAYBACK,
  other?: Readonly<Setup>,
): string {
  const hash = inFull(setup, playback, other);
  return hash === OPENING ? "" : hash;
}

/** The same, but never empty. It has the values that differ from the initial set-up and playback, as `name=value&…`. Those
 * of a set-up with which it is compared follow, the body always, as `with.name=value&…`. */
export function inFull(
  setup: Readonly<Setup>,
  playback: Readonly<Playback> = INITIAL_PLAYBACK,
  other?: Readonly<Setup>,
): string {
  const pairs = changedIn(setup, FIELD_NAMES).map((name) => [name, String(setup[name])]);
  const others = other ? [...new Set(["body" as const, ...changedIn(other, MOTION_FIELDS)])] : [];
  const hash = new URLSearchParams([
    ...pairs,
    ...playbackInLink(playback),
    ...others.map((name) => [OTHER + name, String(other?.[name])]),
  ]).toString();
  return hash || `body=${setup.body}`;
}

const changedIn = (setup: Readonly<Setup>, names: readonly FieldName[]) =>
  names.filter((name) => setup[name] !== INITIAL[name]);

const OPENING = inFull(BY_HAND);

/** Whether the # part of an address holds a set-up and not the name of a part of the page. */
export const holdsSetup = (hash: string): boolean =>
  hash.length <= 1 || hash.includes("=") || hash === "#embed" || hash === "#lab";

/** Reads a link. One that names no quantity shows what the lab opens with. A wrong value gives the initial one and a
 * refusal; if a name appears twice, the last value counts. */
export function fromHash(hash: string): Linked {
  const link = new Map(new URLSearchParams(hash.replace(/^#/, "")));
  const { playback, refusals } = playbackFrom(link);
  const setup = namesAny(link)
    ? setupFrom(link, "", FIELD_NAMES, (refusal) => refusals.push(refusal))
    : { ...BY_HAND };
  const compares = [...link.keys()].some((name) => name.startsWith(OTHER));
  const other = compares
    ? setupFrom(link, OTHER, MOTION_FIELDS, ({ text, message }) =>
        refusals.push({ field: "with", text, message: say(words.compare.inLink, { message }) }),
      )
    : undefined;
  return { setup, playback, other, refusals };
}

const NAMES: ReadonlySet<string> = new Set([...FIELD_NAMES, "speed", "slow", "view"]);

/** Whether a link names a quantity of a set-up, or how it is shown. */
const namesAny = (link: ReadonlyMap<string, string>): boolean =>
  [...link.keys()].some((name) => NAMES.has(name) || name.startsWith(OTHER));

/** The set-up whose names begin with a prefix. */
function setupFrom(
  link: ReadonlyMap<string, string>,
  prefix: string,
  names: readonly FieldName[],
  refuse: (refusal: Refusal) => void,
): Setup {
  const setup: Record<string, string | number> = { ...INITIAL };
  for (const name of names) {
    const text = link.get(prefix + name);
    if (text === undefined) continue;
    const result = read(name, text);
    if ("value" in result) setup[name] = result.value;
    else refuse(result);
  }
  return setup as unknown as Setup;
}
