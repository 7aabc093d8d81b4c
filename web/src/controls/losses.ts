// The rolling resistance of the table, with marks at tables that have none, little and much.

import { button, element } from "../elements";
import type { SetupForm } from "../inputs/setup_form";
import { numberRow } from "../inputs/number";
import { formatExact } from "../format/numbers";
import { BY_HAND } from "../setup/setup";
import { say, words } from "../words/words";
import { placed } from "./marks";

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
