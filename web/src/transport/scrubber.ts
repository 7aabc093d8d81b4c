// A slider that goes to any time of the motion.

import { effect } from "@preact/signals-core";
import { element } from "../elements";
import type { Lab } from "../lab";
import { marks } from "./marks";
import { timeText } from "./readout";
import { words } from "../words/words";

const ARROWS: Record<string, number> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };
/** Frames that an arrow key with Shift moves. */
const LEAP = 10;

export function scrubber(lab: Lab): HTMLElement {
  const range = element("input", {
    type: "range",
    min: "0",
    max: "1",
    step: "any",
    value: "0",
    "aria-label": words.transport.shown,
  });
  range.addEventListener("input", () => {
    lab.clock.pause();
    lab.clock.progress = range.valueAsNumber;
  });
  range.addEventListener("keydown", (event) => {
    const frames = ARROWS[event.key];
    if (frames === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    lab.clock.step(event.shiftKey ? LEAP * frames : frames);
  });
  effect(() => {
    const { clock } = lab;
    range.disabled = lab.motion.value === undefined;
    range.value = String(clock.progress);
    range.style.setProperty("--part", String(clock.progress));
    // While the motion plays, a screen reader would read times without end.
    if (!clock.playing.value)
      range.setAttribute("aria-valuetext", timeText(clock.time.value, clock.end));
  });
  return element("div", { class: "scrubber" }, range, marks(lab));
}
