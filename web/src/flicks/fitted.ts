// A button that asks which friction fits measured falls, and the answer.

import { computed, effect, signal, untracked } from "@preact/signals-core";
import type { Core } from "../core/core";
import { button, element } from "../elements";
import { type Measured, type Trial, fitOf, trials } from "../falls/fit";
import { sliced } from "../falls/sliced";
import { formatFixed } from "../format/numbers";
import type { Setup } from "../setup/setup";
import { say, words } from "../words/words";

/** `setup` and `measured` read signals; the fit varies the table and takes the rest of the set-up as it is. */
export function fitted(
  core: Core,
  setup: () => Readonly<Setup>,
  measured: () => Measured | undefined,
): HTMLElement {
  const { fit } = words.flicks;
  const asked = signal<string | undefined>(undefined);
  const used = computed(() => JSON.stringify([withoutTable(setup()), measured()]));
  const wanted = computed(() => asked.value === used.value);
  const { results, complete } = sliced(() => {
    const falls = measured();
    return wanted.value && falls
      ? trials(core, untracked(setup), falls)
      : ([] as (Trial | undefined)[]).values();
  });
  const ask = button(fit.ask, () => (asked.value = used.peek()));
  const said = element("p", { class: "fit", role: "status" });
  effect(() => {
    ask.hidden = measured() === undefined;
    const best = wanted.value && complete.value ? fitOf(results.value) : undefined;
    said.textContent = !wanted.value
      ? ""
      : !complete.value
        ? fit.running
        : best
          ? say(fit.answer, {
              friction: formatFixed(best.friction, 2),
              low: formatFixed(best.low, 2),
              high: formatFixed(best.high, 2),
            })
          : fit.none;
  });
  return element("div", { class: "fitted" }, ask, said);
}

/** The set-up without what the fit varies. */
const withoutTable = (setup: Readonly<Setup>): Partial<Setup> => ({
  ...setup,
  law: "coulomb",
  friction: 0,
  flicks: 0,
  unsteadiness: 0,
});
