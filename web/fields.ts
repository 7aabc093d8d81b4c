// A plugin that writes the table of fields to a file beside the page. `rimroll lab --setup` checks a
// set-up with the same table as the page.

import type { Plugin } from "vite";
import {
  type ChoiceField,
  FIELDS,
  MOTION_FIELDS,
  type NumberField,
  OTHER,
  type RecordField,
} from "./src/setup/fields";
import { SPEEDS, VIEWS } from "./src/setup/playback";
import { STEPS } from "./src/story/steps";

/** The accepted values of a quantity: choices, texts of a pattern, or numbers within bounds. */
type Allowed =
  | { choices: string[] }
  | { pattern: string }
  | Pick<NumberField, "unit" | "min" | "max" | "open" | "whole">;

export function fields(file: string): Plugin {
  return {
    name: "fields",
    apply: "build",
    generateBundle() {
      this.emitFile({ type: "asset", fileName: file, source: JSON.stringify(allowed(), null, 1) });
    },
  };
}

/** The accepted values of each quantity by name. */
export function allowed(): Record<string, Allowed> {
  const quantities = Object.entries<NumberField | ChoiceField | RecordField>(FIELDS).map(
    ([name, field]): [string, Allowed] => {
      if (field.kind === "choice") return [name, { choices: Object.keys(field.choices) }];
      if (field.kind === "record") return [name, { pattern: field.pattern }];
      const { unit, min, max, open = false, whole = false } = field;
      return [name, { unit, min, max, open, whole }];
    },
  );
  const playback = {
    speed: { choices: SPEEDS.map(String) },
    slow: { choices: ["0", "1"] },
    view: { choices: [...VIEWS] },
    step: { choices: STEPS.map((_, k) => String(k + 1)) },
  };
  const all = Object.fromEntries(quantities);
  const compared = MOTION_FIELDS.map((name): [string, Allowed] => [OTHER + name, all[name]!]);
  return { ...all, ...playback, ...Object.fromEntries(compared) };
}
