// Inputs of the set-up: numbers with a slider and a field, choices as a list or as buttons.

import { effect } from "@preact/signals-core";
import { type ChoiceField, type FieldName, FIELDS, type NumberField } from "../setup/fields";
import { element } from "../elements";
import type { SetupForm } from "./setup_form";
import { formatExact, formatNumber, withUnit } from "../format";

/** Names of the number fields. */
export type NumberName = {
  [Name in FieldName]: (typeof FIELDS)[Name]["kind"] extends "number" ? Name : never;
}[FieldName];

export interface Row {
  row: HTMLElement;
  slider: HTMLInputElement;
}

/** `idle` returns the reason why the number has no effect at present, or undefined. */
export function numberRow(
  form: SetupForm,
  name: NumberName,
  idle: () => string | undefined = () => undefined,
): Row {
  const field: NumberField = FIELDS[name];
  const scale = scaleOf(field);
  const id = (part: string) => `${name}-${part}`;
  const named = { "aria-labelledby": `${id("label")} ${id("unit")}` };
  const described = { "aria-describedby": `${id("help")} ${id("refusal")}` };

  const label = element("label", { id: id("label"), for: id("field") }, field.label);
  const slider = element("input", {
    type: "range",
    id: id("slider"),
    min: scale.low,
    max: scale.high,
    step: scale.step || "any",
    ...named,
    ...described,
  });
  slider.classList.toggle("both-ways", scale.low < 0);
  const typed = element("input", {
    type: "text",
    id: id("field"),
    inputmode: "text",
    autocomplete: "off",
    spellcheck: "false",
    ...named,
    ...described,
  });
  const unit = element("span", { id: id("unit"), class: "unit" }, field.unit);
  const help = element("p", { id: id("help"), class: "help" }, field.help);
  const refusal = element("p", { id: id("refusal"), class: "refusal", role: "alert" });
  const row = element("div", { class: "quantity", "data-help": field.help });
  row.append(label, slider, typed, unit, help, refusal);

  slider.addEventListener("input", () => form.set(name, scale.value(Number(slider.value))));
  // Text that is being typed is not overwritten when something else changes.
  let typing = false;
  typed.addEventListener("input", () => (typing = true));
  typed.addEventListener("change", () => {
    typing = false;
    form.type(name, typed.value);
  });
  typed.addEventListener("blur", () => (typing = false));

  effect(() => {
    const value = form.lab.setup.value[name];
    const refused = form.lab.refusals.value.find((one) => one.field === name);
    refusal.textContent = refused?.message ?? "";
    typed.setAttribute("aria-invalid", String(refused !== undefined));
    slider.value = String(scale.position(value));
    slider.setAttribute("aria-valuetext", withUnit(formatNumber(value), field.unit));
    // A refused text stays as it was typed, so that it can be corrected.
    if (!typing) typed.value = refused?.text ?? formatExact(value);
  });
  effect(() => {
    const reason = idle();
    slider.disabled = typed.disabled = reason !== undefined;
    help.textContent = reason ?? field.help;
    row.dataset["help"] = help.textContent;
    row.classList.toggle("idle", reason !== undefined);
  });
  return { row, slider };
}

// One choice of the set-up, as a list or as radio buttons side by side.

/** Names of the choices. */
type ChoiceName = {
  [Name in FieldName]: (typeof FIELDS)[Name]["kind"] extends "choice" ? Name : never;
}[FieldName];

export function choiceList(form: SetupForm, name: ChoiceName): HTMLElement {
  const field: ChoiceField = FIELDS[name];
  const id = (part: string) => `${name}-${part}`;
  const label = element("label", { id: id("label"), for: id("field") }, field.label);
  const list = element("select", {
    id: id("field"),
    "aria-describedby": `${id("help")} ${id("refusal")}`,
  });
  for (const [value, text] of Object.entries(field.choices))
    list.append(element("option", { value }, text));
  list.addEventListener("change", () => form.set(name, list.value));
  effect(() => {
    list.value = form.lab.setup.value[name];
  });
  const row = element("div", { class: "quantity choice", "data-help": field.help });
  row.append(label, list, ...words(form, name, field));
  return row;
}

export function choiceButtons(form: SetupForm, name: ChoiceName): HTMLElement {
  const field: ChoiceField = FIELDS[name];
  const group = element("fieldset", {
    class: "choices",
    "data-help": field.help,
    "aria-describedby": `${name}-help ${name}-refusal`,
  });
  group.append(element("legend", {}, field.label));
  for (const [value, text] of Object.entries(field.choices)) {
    const one = element("input", { type: "radio", name, value, id: `${name}-${value}` });
    one.addEventListener("change", () => form.set(name, value));
    effect(() => {
      one.checked = form.lab.setup.value[name] === value;
    });
    group.append(element("label", { for: one.id, class: value }, one, element("span", {}, text)));
  }
  group.append(...words(form, name, field));
  return group;
}

/** The help text of a choice and the refusal of one in a link. */
function words(form: SetupForm, name: ChoiceName, field: ChoiceField): HTMLElement[] {
  const help = element("p", { id: `${name}-help`, class: "help" }, field.help);
  const refusal = element("p", { id: `${name}-refusal`, class: "refusal", role: "alert" });
  effect(() => {
    const refused = form.lab.refusals.value.find((one) => one.field === name);
    refusal.textContent = refused?.message ?? "";
  });
  return [help, refusal];
}

// Converts between a value and its position on a slider.

/** The positions of a slider and their values. */
export interface Scale {
  low: number;
  high: number;
  step: number;
  /** The value at a position. */
  value(position: number): number;
  position(value: number): number;
}

export function scaleOf(field: NumberField): Scale {
  const [low, high, step] = field.slider ?? [field.min, field.max, 0];
  if (field.finest !== undefined) return signedLog(field.finest, high);
  const identity = (x: number) => x;
  return { low, high, step, value: identity, position: identity };
}

const PER_DECADE = 20;

/** A logarithmic scale on both sides of 0, which is in the middle, with PER_DECADE steps per decade from
 * the finest to the largest value. */
function signedLog(finest: number, largest: number): Scale {
  const steps = Math.ceil(PER_DECADE * Math.log10(largest / finest));
  const size = (position: number) => finest * 10 ** ((Math.abs(position) - 1) / PER_DECADE);
  return {
    low: -steps - 1,
    high: steps + 1,
    step: 1,
    value: (position) =>
      position === 0
        ? 0
        : Math.sign(position) * Math.min(Number(size(position).toPrecision(2)), largest),
    position: (value) => {
      const distance = Math.abs(value) / finest;
      if (distance < 1) return 0;
      return Math.sign(value) * Math.min(1 + PER_DECADE * Math.log10(distance), steps + 1);
    },
  };
}
