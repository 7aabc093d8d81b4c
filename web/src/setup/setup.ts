// A set-up: the body, its release and the table, with numbers in the units of their fields.

import { withUnit } from "../format/numbers";
import type { LawName, Preset } from "../core/core";
import { type Described, FIELDS, FIELD_NAMES, type FieldName, type NumberField } from "./fields";
import { type Refusal, noSuchChoice } from "./refusal";

type Values = {
  [Name in FieldName]: (typeof FIELDS)[Name]["kind"] extends "number" ? number : string;
};

export interface Setup extends Values {
  body: Preset | Described;
  law: LawName;
  floor: keyof (typeof FIELDS)["floor"]["choices"];
  start: keyof (typeof FIELDS)["start"]["choices"];
  pulse: keyof (typeof FIELDS)["pulse"]["choices"];
  flat: keyof (typeof FIELDS)["flat"]["choices"];
}

export const INITIAL = Object.freeze(
  Object.fromEntries(FIELD_NAMES.map((name) => [name, FIELDS[name].initial])),
) as Readonly<Setup>;

/** Reads a value from a text, or gives the reason why it is refused. */
export function read(name: FieldName, text: string): { value: string | number } | Refusal {
  const field: (typeof FIELDS)[FieldName] = FIELDS[name];
  if (field.kind === "choice") {
    if (Object.hasOwn(field.choices, text)) return { value: text };
    const message = noSuchChoice(field.label, Object.values(field.choices), text);
    return { field: name, text, message };
  }
  if (field.kind === "record") {
    if (new RegExp(`^(${field.pattern})$`).test(text)) return { value: text };
    return { field: name, text, message: `${field.label}: this is not a record of the page.` };
  }
  const bare = withoutUnit(text.trim(), field);
  // Accept a decimal comma, and a minus sign as well as a hyphen.
  const value = Number(bare.replace(",", ".").replaceAll("−", "-") || NaN);
  const message = outOfBounds(field, value, bare);
  return message === undefined ? { value } : { field: name, text, message };
}

/** Removes the unit after a number, if there is one. */
const withoutUnit = (text: string, { unit }: NumberField): string =>
  unit !== "" && text.endsWith(unit) ? text.slice(0, -unit.length).trim() : text;

/** Numbers such as 1,000: either a thousand or one with three decimals. */
const THOUSANDS = /^\s*[-+−]?[1-9]\d{0,2}(,\d{3})+\s*$/;

function outOfBounds(field: NumberField, value: number, text: string): string | undefined {
  const { label, unit, min, max, open, whole } = field;
  if (THOUSANDS.test(text))
    return `${label}: “${text.trim()}” can be read in two ways; write a point before decimals and nothing between thousands.`;
  if (text.trim() === "") return `${label} needs a number.`;
  if (Number.isNaN(value)) return `${label} must be a number, not “${text}”.`;
  if (whole && !Number.isInteger(value))
    return `${label} must be a whole number, not ${text.trim()}.`;
  const inside = open ? value > min && value < max : value >= min && value <= max;
  if (inside) return undefined;
  const [low, high] = [withUnit(String(min), unit), withUnit(String(max), unit)];
  const bounds = open ? `more than ${low} and less than ${high}` : `from ${min} to ${high}`;
  return `${label} must be ${bounds}; ${text.trim()} is outside.`;
}
