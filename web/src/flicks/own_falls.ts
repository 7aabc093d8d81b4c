// Falls that visitors measured themselves: typed, pooled with those of other groups by their links, and kept in the link.

import { computed, effect } from "@preact/signals-core";
import { button, element, svgElement } from "../elements";
import { fallsFromLink, fallsInLink, fallsTyped, tallyOfFalls } from "../falls/given";
import type { Measured } from "../falls/fit";
import { inWords } from "../falls/summary";
import type { Lab } from "../lab";
import { binsFor } from "../story/bins";
import { HEIGHT, WIDTH, humps } from "../story/humps";
import { words } from "../words/words";
import { fitted } from "./fitted";

export function ownFalls(lab: Lab): HTMLElement {
  const { own } = words.flicks;
  const typed = element("textarea", { id: "own-falls", rows: 2, spellcheck: "false" });
  const refusal = element("p", { class: "refusal", role: "alert" });
  const add = button(own.add, () => {
    const more = fallsTyped(typed.value);
    refusal.textContent = more ? "" : own.refused;
    if (!more) return;
    lab.change({ falls: fallsInLink([...directions.value, ...more]) });
    typed.value = "";
  });
  const clear = button(own.clear, () => {
    lab.change({ falls: "" });
    typed.focus();
  });
  const picture = svgElement("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img" });
  const said = element("p", { role: "status" });
  const directions = computed(() => fallsFromLink(lab.setup.value.falls));
  const tally = computed(() => tallyOfFalls(directions.value));
  const measured = (): Measured | undefined =>
    Math.max(tally.value.left.count, tally.value.right.count) < 2 ? undefined : tally.value;
  const result = element(
    "div",
    { class: "result falls" },
    picture as unknown as HTMLElement,
    said,
    fitted(lab.core, () => lab.setup.value, measured),
  );
  const details = element(
    "details",
    { class: "own-falls" },
    element("summary", {}, own.title),
    element("label", { for: typed.id, class: "hint" }, own.help),
    typed,
    refusal,
    element("div", { class: "row" }, add, clear),
    result,
  );
  effect(() => {
    const theory = lab.theory.value;
    const { left, right } = tally.value;
    result.hidden = clear.hidden = directions.value.length === 0;
    if (result.hidden) return;
    details.open = true;
    const bins = binsFor(theory, [...left.turns, ...right.turns]);
    picture.innerHTML = humps({ tally: tally.value, theory, bins, measured: false });
    said.textContent = inWords(tally.value, directions.value.length);
    picture.setAttribute("aria-label", said.textContent);
  });
  return details;
}
