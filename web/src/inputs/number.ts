// One number of the set-up: its label, a slider for the usual range, a field for any value, its unit,
// its help text and the refusal of a value.

import { effect } from "@preact/signals-core";
import { FIELDS, type FieldName, type NumberField } from "../setup/fields";
import { element } from "../elements";
import type { SetupForm } from "./setup_form";
import { scaleOf } from "./scale";
import { formatExact, formatNumber, withUnit } from "../format/numbers";

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
