// A plugin that puts beside the page what its set-up consists of, for who opens it with one: what
// `rimroll lab --setup` is given is checked by the same table as what is typed in the page.

import type { Plugin } from "vite";
import { FIELDS, type NumberField, type ChoiceField } from "./src/setup/fields";
import { SPEEDS } from "./src/setup/playback";

/** What a quantity may be: one of some words, or a number. */
type Allowed =
  { choices: string[] } | Pick<NumberField, "unit" | "least" | "most" | "open" | "whole">;

export function fields(file: string): Plugin {
  return {
    name: "fields",
    apply: "build",
    generateBundle() {
      this.emitFile({ type: "asset", fileName: file, source: JSON.stringify(allowed(), null, 1) });
    },
  };
}

/** What the page takes, by name. */
export function allowed(): Record<string, Allowed> {
  const quantities = Object.entries<NumberField | ChoiceField>(FIELDS).map(
    ([name, field]): [string, Allowed] => {
      if (field.kind === "choice") return [name, { choices: Object.keys(field.choices) }];
      const { unit, least, most, open = false, whole = false } = field;
      return [name, { unit, least, most, open, whole }];
    },
  );
  const pace = { speed: { choices: SPEEDS.map(String) }, slow: { choices: ["0", "1"] } };
  return { ...Object.fromEntries(quantities), ...pace };
}
