// The friction of the table, with marks at what tables are made of and at what the body needs.

import { effect } from "@preact/signals-core";
import { button, element } from "../elements";
import type { SetupForm } from "../inputs/setup_form";
import { numberRow } from "../inputs/number";
import { scaleOf } from "../inputs/scale";
import { FIELDS } from "../setup/fields";

/** Dry friction of a metal rim, as rimroll.surfaces. */
const TABLES = { ice: 0.03, wood: 0.3, rubber: 0.8 };

/** As parts of the slider: a word in the middle over a place so far on would begin before the slider. */
const NEAR_THE_START = 0.08;

const IDLE: Record<string, string> = {
  frictionless: "Without any friction there is no number to set.",
  no_slip: "Without any slip, friction is as great as it needs to be.",
};

/** Why dry friction's numbers do not matter, if they do not. */
export const idleUnderIdealLaws = (form: SetupForm) => () => IDLE[form.lab.setup.value.law];

export function frictionRow(form: SetupForm): HTMLElement {
  const { row, slider } = numberRow(form, "friction", idleUnderIdealLaws(form));
  const marks = element("div", { class: "marks" });
  for (const [table, friction] of Object.entries(TABLES))
    marks.append(
      placed(
        button(table, () => form.set("friction", friction), {
          "aria-label": `Friction of ${table}, ${friction}`,
        }),
        friction,
      ),
    );
  const needed = element("div", { class: "marks needed" });
  // Rounded up, so that it does roll.
  const mark = button("", () => form.set("friction", Math.ceil(1e4 * neededFriction(form)) / 1e4));
  needed.append(mark);
  slider.before(needed);
  slider.after(marks);
  row.classList.add("friction");
  effect(() => {
    const friction = neededFriction(form);
    needed.hidden = !(friction >= 0);
    const words = `μ* ${friction.toFixed(3)}`;
    mark.textContent = words;
    mark.setAttribute("aria-label", `${words}, with which this body just rolls through`);
    mark.dataset["help"] =
      `With ${words} or more this body rolls through its near-collision; with less it slips.`;
    placed(mark, friction);
  });
  effect(() => {
    const idle = idleUnderIdealLaws(form)() !== undefined;
    for (const one of row.querySelectorAll("button")) one.disabled = idle;
  });
  return row;
}

const neededFriction = (form: SetupForm) => form.lab.theory.value?.neededFriction ?? NaN;

/** Puts a mark at its place along the slider; at the end if it is beyond. */
function placed(mark: HTMLElement, friction: number): HTMLElement {
  const { low, high } = scaleOf(FIELDS.friction);
  const part = Math.min((friction - low) / (high - low), 1);
  mark.style.setProperty("--part", String(part));
  mark.classList.toggle("beyond", friction > high);
  mark.classList.toggle("first", part < NEAR_THE_START);
  return mark;
}
