// The bar above the plots: the stretch shown, zoom buttons, and a choice of plot on a narrow page.

import { effect } from "@preact/signals-core";
import { element } from "../elements";
import type { Lab } from "../lab";
import type { Figure } from "./figures";
import { stretchText } from "./ticks";
import type { View } from "./view";

/** The phases and their colours. */
const PHASES = { rolling: "rolling", sliding: "sliding", flying: "flying", lying: "muted" };

export function toolbar(lab: Lab, view: View): HTMLElement {
  const about = () => {
    const { origin, from, to } = view.shown.value;
    const now = lab.clock.time.value - origin;
    return now >= from && now <= to ? now : (from + to) / 2;
  };
  const whole = button("Whole motion", "", () => view.whole());
  const close = button("This collision", "Shows the collision nearest to the time shown", () =>
    view.close(lab.clock.time.value),
  );
  const nearer = button("+", "Zoom in", () => view.zoom(2, about()));
  const farther = button("−", "Zoom out", () => view.zoom(0.5, about()));
  const shown = element("span", { class: "shown" });
  effect(() => {
    shown.textContent = `Shown: ${stretchText(view.shown.value)}`;
    whole.disabled = farther.disabled = view.isWhole;
    close.disabled = view.collisions.value.length === 0;
  });
  return element(
    "div",
    { class: "tools" },
    element(
      "div",
      { class: "buttons", role: "group", "aria-label": "Zoom" },
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
    now.textContent = phase ? `At the time shown it is ${phase.kind}.` : "";
  });
  const entries = Object.entries(PHASES).map(([phase, colour]) => {
    const swatch = element("i", { class: "area", style: `--swatch: var(--${colour})` });
    const entry = element("span", { class: "entry" }, swatch, phase);
    effect(() => {
      entry.hidden = !lab.motion.value?.phases.some(({ kind }) => kind === phase);
    });
    return entry;
  });
  return element("p", { class: "phases" }, "Shaded: ", ...entries, now);
}

/** The choice of one figure on a narrow page. */
export function chooser(
  figures: readonly Figure[],
  chosen: string,
  choose: (name: string) => void,
): HTMLElement {
  const choices = figures.map(({ name, title }) => {
    const radio = element("input", {
      type: "radio",
      name: "plot-chosen",
      value: name,
      checked: name === chosen,
    });
    radio.addEventListener("change", () => choose(name));
    return element("label", {}, radio, element("span", {}, title.split(" ")[0] as string));
  });
  return element("div", { class: "chooser", role: "radiogroup", "aria-label": "Plot" }, ...choices);
}

function button(text: string, title: string, press: () => void): HTMLButtonElement {
  const named = text.length === 1 ? { "aria-label": title } : {};
  const made = element("button", { type: "button", title, ...named }, text);
  made.addEventListener("click", press);
  return made;
}
