// The friction and the rolling resistance of the table, with marks along their sliders: buttons with the names of some values.

import { effect } from "@preact/signals-core";
import { button, element } from "../elements";
import type { SetupForm } from "./setup_form";
import { type NumberName, numberRow, scaleOf } from "./inputs";
import { formatExact, formatFixed } from "../format";
import { say, words } from "../words/words";
import { BY_HAND } from "../setup/setup";
import { FIELDS } from "../setup/fields";

/** Dry friction of a metal rim on these materials, as in rimroll.laws.surfaces. */
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

// The rolling resistance of the table, with marks at tables that have none, little and much.

/** Resisting force over normal force. */
const LOSSES = { none: 0, hard: BY_HAND.rolling, soft: 4 * BY_HAND.rolling } as const;

export function lossesRow(form: SetupForm): HTMLElement {
  const { row, slider } = numberRow(form, "rolling");
  const marks = element("div", { class: "marks" });
  for (const table of ["none", "hard", "soft"] as const) {
    const resistance = LOSSES[table];
    const name = words.controls.losses[table];
    const mark = button(name, () => form.set("rolling", resistance), {
      "aria-label": say(words.controls.lossesOf, {
        table: name,
        resistance: formatExact(resistance),
      }),
    });
    marks.append(placed(mark, "rolling", resistance));
  }
  slider.after(marks);
  row.classList.add("marked");
  return row;
}

// Marks along a slider: buttons with the names of some of its values.

/** A label centred nearer to the start of the slider (as a fraction of it) would begin outside it. */
const NEAR_THE_START = 0.08;

/** Puts a mark at the place of a value along its slider, or at the end if it lies beyond. */
export function placed(mark: HTMLElement, name: NumberName, value: number): HTMLElement {
  const { low, high } = scaleOf(FIELDS[name]);
  const part = Math.min((value - low) / (high - low), 1);
  mark.style.setProperty("--part", String(part));
  mark.classList.toggle("beyond", value > high);
  mark.classList.toggle("first", part < NEAR_THE_START);
  return mark;
}
