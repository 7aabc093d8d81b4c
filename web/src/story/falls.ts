// A straight histogram of the falls, for the steps of the story that flick the body.

import { effect, computed } from "@preact/signals-core";
import { element } from "../elements";
import { tallyOf } from "../falls/tally";
import { flickSummary } from "../falls/summary";
import type { Lab } from "../lab";
import { binsFor } from "./bins";
import { HEIGHT, WIDTH, humps } from "./humps";
import { say, sentences, words } from "../words/words";

/** The histogram, hidden unless the current step wants it; `wanted` reads signals. */
export function fallsOf(lab: Lab, wanted: () => boolean): HTMLElement {
  const figure = element("figure", { class: "falls" });
  figure.innerHTML = `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img"></svg><figcaption></figcaption>`;
  const picture = figure.querySelector("svg") as SVGElement;
  const caption = figure.querySelector("figcaption") as HTMLElement;
  // The range covers all falls, so that the axis does not move while they appear.
  const bins = computed(() => {
    const { left, right } = tallyOf(lab.flicks.value);
    return binsFor(lab.theory.value, [...left.turns, ...right.turns]);
  });
  effect(() => {
    figure.hidden = !wanted();
    if (figure.hidden) return;
    const theory = lab.theory.value;
    const measured = lab.setup.value.body === "can_2007";
    const tally = tallyOf(lab.flicks.value.slice(0, lab.flicksShown.value ?? 0));
    picture.innerHTML = humps({ tally, theory, bins: bins.value, measured });
    const { from, to, width } = bins.value;
    picture.setAttribute(
      "aria-label",
      sentences(
        say(words.story.histogram, { from: `${from}°`, to: `${to}°`, width: `${width}°` }),
        flickSummary(lab),
      ),
    );
    caption.textContent = sentences(
      say(words.story.caption, { width: `${width}°` }),
      measured ? words.story.measured : "",
    );
  });
  return figure;
}
