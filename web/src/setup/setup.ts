// A set-up: the body, its release and the table, with numbers in the units of their fields.

import { formatExact, withUnit } from "../format";
import { NUMBERS, type NumberStyle } from "../words/language";
import { choiceOf, say, words } from "../words/words";
import type { LawName } from "../core/core";
import {
  type BodyName,
  FIELD_NAMES,
  type FieldName,
  FIELDS,
  type NumberField,
  type Refusal,
} from "./fields";

type Values = {
  [Name in FieldName]: (typeof FIELDS)[Name]["kind"] extends "number" ? number : string;
};

export interface Setup extends Values {
  body: BodyName;
  law: LawName;
  floor: keyof (typeof FIELDS)["floor"]["choices"];
  start: keyof (typeof FIELDS)["start"]["choices"];
  pulse: keyof (typeof FIELDS)["pulse"]["choices"];
  flat: keyof (typeof FIELDS)["flat"]["choices"];
}

/** The set-up whose values links leave out. It stays as it is, so that links that were sent open as before. */
export const INITIAL = Object.freeze(
  Object.fromEntries(FIELD_NAMES.map((name) => [name, FIELDS[name].initial])),
) as Readonly<Setup>;

/** The sideways error of a hand that lets a can go, rad/s. */
export const HAND_ERROR = 0.02;

/** The set-up with which the lab opens: a can that a hand lets go. It loses 5 % of its energy in the first turn, and the gap, the
 * speed and the force are those that a real can may have. */
export const BY_HAND: Readonly<Setup> = Object.freeze({
  ...INITIAL,
  sideways: HAND_ERROR,
  rolling: 1e-4,
  // Before it slaps the table.
  duration: 1.8,
});

/** Numbers in links, which have a decimal point in every language. */
const IN_LINKS: Pick<NumberStyle, "decimal"> = { decimal: "." };

/** Reads what a visitor typed. */
export const readTyped = (name: FieldName, text: string) => read(name, text, NUMBERS);

/** Reads a value from a text, or gives the reason why it is refused. */
export function read(
  name: FieldName,
  text: string,
  { decimal } = IN_LINKS,
): { value: string | number } | Refusal {
  const field: (typeof FIELDS)[FieldName] = FIELDS[name];
  if (field.kind === "choice") {
    if (Object.hasOwn(field.choices, text)) return { value: text };
    const message = say(words.refusals.noSuchChoice, {
      label: field.label,
      ...choiceOf(Object.values(field.choices)),
      text,
    });
    return { field: name, text, message };
  }
  if (field.kind === "record") {
    if (new RegExp(`^(${field.pattern})$`).test(text)) return { value: text };
    return { field: name, text, message: say(words.refusals.noRecord, { label: field.label }) };
  }
  const bare = withoutUnit(text.trim(), field);
  // Accept a decimal comma and a point, and a minus sign as well as a hyphen.
  const value = Number(bare.replace(",", ".").replaceAll("−", "-") || NaN);
  const message = outOfBounds(field, value, bare, decimal);
  return message === undefined ? { value } : { field: name, text, message };
}

/** Removes the unit after a number, if there is one. */
const withoutUnit = (text: string, { unit }: NumberField): string =>
  unit !== "" && text.endsWith(unit) ? text.slice(0, -unit.length).trim() : text;

/** Numbers such as 1,000 where decimals have a point: either a thousand or one with three decimals. */
const THOUSANDS = {
  ".": /^\s*[-+−]?[1-9]\d{0,2}(,\d{3})+\s*$/,
  ",": /^\s*[-+−]?[1-9]\d{0,2}(\.\d{3})+\s*$/,
};

function outOfBounds(
  field: NumberField,
  value: number,
  text: string,
  decimal: NumberStyle["decimal"],
): string | undefined {
  const { label, unit, min, max, open, whole } = field;
  const { refusals } = words;
  if (THOUSANDS[decimal].test(text))
    return say(refusals.twoReadings, {
      label,
      text: text.trim(),
      sign: decimal === "." ? "point" : "comma",
    });
  if (text.trim() === "") return say(refusals.empty, { label });
  if (Number.isNaN(value)) return say(refusals.noNumber, { label, text });
  if (whole && !Number.isInteger(value))
    return say(refusals.notWhole, { label, text: text.trim() });
  const inside = open ? value > min && value < max : value >= min && value <= max;
  if (inside) return undefined;
  const [low, high] = [formatExact(min), withUnit(formatExact(max), unit)];
  return open
    ? say(refusals.between, { label, low: withUnit(low, unit), high, text: text.trim() })
    : say(refusals.fromTo, { label, low, high, text: text.trim() });
}
