// One choice of the set-up, as a list or as radio buttons side by side.

import { effect } from "@preact/signals-core";
import { type ChoiceField, FIELDS, type FieldName } from "../setup/fields";
import { element } from "../elements";
import type { SetupForm } from "./setup_form";

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
