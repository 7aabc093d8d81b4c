// The whole set-up in the part of the address after #, so that a link holds it and no server sees it.

import { FIELDS, FIELD_NAMES, type FieldName } from "./fields";
import { INITIAL, type Refusal, type Setup, read } from "./setup";

/** What differs from the initial set-up, as `name=value&…`. */
export function toHash(setup: Readonly<Setup>): string {
  const changed = FIELD_NAMES.filter((name) => setup[name] !== INITIAL[name]);
  return new URLSearchParams(changed.map((name) => [name, String(setup[name])])).toString();
}

/** The set-up that a link holds; what it holds wrongly stays as it is initially, with the reason. */
export function fromHash(hash: string): { setup: Setup; refusals: Refusal[] } {
  const setup: Record<string, string | number> = { ...INITIAL };
  const refusals: Refusal[] = [];
  for (const [name, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
    if (!Object.hasOwn(FIELDS, name)) continue;
    const result = read(name as FieldName, text);
    if ("value" in result) setup[name] = result.value;
    else refusals.push(result);
  }
  return { setup: setup as unknown as Setup, refusals };
}
