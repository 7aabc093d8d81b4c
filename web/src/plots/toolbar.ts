// The bar above the plots: the stretch shown, zoom buttons, and a choice of plot on a narrow page.

import { effect, type Signal } from "@preact/signals-core";
import { element } from "../elements";
import type { Lab } from "../lab";
import { type Figure, FLOOR } from "./figures";
import { stretchText } from "./ticks";
import type { View } from "./view";
import { say, words } from "../words/words";

/** The phases and their colours. */
const PHASES = {
  standing: "plot-fourth",
  rolling: "rolling",
  sliding: "sliding",
  sliding_flat: "sliding",
  flying: "flying",
  flying_level: "flying",
  lying: "muted",
};

const inWords = (phase: string) => words.plots.phases[phase as keyof typeof PHASES] ?? phase;

export function toolbar(lab: Lab, view: View): HTMLElement {
  const about = () => {
    const { origin, from, to } = view.shown.value;
    const now = lab.clock.time.value - origin;
    return now >= from && now <= to ? now : (from + to) / 2;
  };
  const whole = button(words.plots.whole, "", () => view.whole());
  const close = button(words.plots.close, words.plots.closeHelp, () =>
    view.close(lab.clock.time.value),
  );
  const nearer = button("+", words.plots.zoomIn, () => view.zoom(2, about()));
  const farther = button("−", words.plots.zoomOut, () => view.zoom(0.5, about()));
  const shown = element("span", { class: "shown" });
  effect(() => {
    shown.textContent = say(words.plots.shown, { stretch: stretchText(view.shown.value) });
    whole.disabled = farther.disabled = view.isWhole;
    close.disabled = view.collisions.value.length === 0;
  });
  return element(
    "div",
    { class: "tools" },
    element(
      "div",
      { class: "buttons", role: "group", "aria-label": words.plots.zoom },
      whole,
      close,
      nearer,
      farther,
    ),
    shown,
  );
}

/** The key to the shades, and the phase at the time shown. */
export function phaseKey(lab: Lab): HTMLElement {
  const now = element("span", { class: "now" });
  effect(() => {
    const time = lab.clock.time.value;
    const phase = lab.motion.value?.phases.findLast((phase) => phase.start <= time);
    now.textContent = phase ? say(words.plots.now, { phase: inWords(phase.kind) }) : "";
  });
  const entries = Object.entries(PHASES).map(([phase, colour]) => {
    const swatch = element("i", { class: "area", style: `--swatch: var(--${colour})` });
    const entry = element("span", { class: "entry" }, swatch, inWords(phase));
    effect(() => {
      entry.hidden = !lab.motion.value?.phases.some(({ kind }) => kind === phase);
    });
    return entry;
  });
  return element("p", { class: "phases" }, words.plots.shaded, ...entries, now);
}

/** The choice of one figure on a narrow page. */
export function chooser(lab: Lab, figures: readonly Figure[], chosen: Signal<string>): HTMLElement {
  const choices = figures.map(({ name, short }) => {
    const radio = element("input", {
      type: "radio",
      name: "plot-chosen",
      value: name,
    });
    radio.addEventListener("change", () => (chosen.value = name));
    effect(() => {
      radio.checked = name === chosen.value;
    });
    const label = element("label", {}, radio, element("span", {}, short));
    if (name === FLOOR)
      effect(() => {
        label.hidden = !lab.shaking.value;
        if (label.hidden && chosen.peek() === FLOOR) chosen.value = "tilt";
      });
    return label;
  });
  return element(
    "div",
    { class: "chooser", role: "radiogroup", "aria-label": words.plots.plot },
    ...choices,
  );
}

function button(text: string, title: string, press: () => void): HTMLButtonElement {
  const named = text.length === 1 ? { "aria-label": title } : {};
  const made = element("button", { type: "button", title, ...named }, text);
  made.addEventListener("click", press);
  return made;
}
