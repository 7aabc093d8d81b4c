// The friction of the table, with marks at typical materials and at the needed friction of the body.

import { effect } from "@preact/signals-core";
import { button, element } from "../elements";
import type { SetupForm } from "../inputs/setup_form";
import { numberRow } from "../inputs/number";
import { formatExact, formatFixed } from "../format/numbers";
import { say, words } from "../words/words";
import { placed } from "./marks";

/** Dry friction of a metal rim on these materials, as in rimroll.surfaces. */
const TABLES = { ice: 0.03, wood: 0.3, rubber: 0.8 } as const;

/** Under an ideal law, the reason why the settings of dry friction have no effect. */
export const idleUnderIdealLaws = (form: SetupForm) => () =>
  form.lab.setup.value.law === "coulomb" ? undefined : words.controls.dryOnly;

export function frictionRow(form: SetupForm): HTMLElement {
  const { row, slider } = numberRow(form, "friction", idleUnderIdealLaws(form));
  const marks = element("div", { class: "marks" });
  for (const table of ["ice", "wood", "rubber"] as const) {
    const friction = TABLES[table];
    const name = words.controls.tables[table];
    marks.append(
      placed(
        button(name, () => form.set("friction", friction), {
          "aria-label": say(words.controls.frictionOf, {
            table: name,
            friction: formatExact(friction),
          }),
        }),
        "friction",
        friction,
      ),
    );
  }
  const needed = element("div", { class: "marks needed" });
  // Rounded up, so that the body does roll.
  const mark = button("", () => form.set("friction", Math.ceil(1e4 * neededFriction(form)) / 1e4));
  needed.append(mark);
  slider.before(needed);
  slider.after(marks);
  row.classList.add("marked");
  effect(() => {
    const friction = neededFriction(form);
    needed.hidden = !(friction >= 0);
    const text = `μ* ${formatFixed(friction, 3)}`;
    mark.textContent = text;
    mark.setAttribute("aria-label", say(words.controls.neededLabel, { friction: text }));
    mark.dataset["help"] = say(words.controls.neededHelp, { friction: text });
    placed(mark, "friction", friction);
  });
  effect(() => {
    const idle = idleUnderIdealLaws(form)() !== undefined;
    for (const one of row.querySelectorAll("button")) one.disabled = idle;
  });
  return row;
}

const neededFriction = (form: SetupForm) => form.lab.theory.value?.neededFriction ?? NaN;
