// Five plots over one axis of time, linked to the time shown.

import { computed, effect, signal } from "@preact/signals-core";
import "uplot/dist/uPlot.min.css";
import { element } from "../elements";
import type { Lab } from "../lab";
import { Chart } from "./chart";
import { FIGURES, type Subject } from "./figures";
import { attachGestures } from "./gestures";
import { paletteOf } from "./palette";
import "./plots.css";
import { sampled } from "./sampled";
import { chooser, phaseKey, toolbar } from "./toolbar";
import { View } from "./view";

/** Below this width (CSS px) of the page one plot is shown at a time. */
const NARROW = "(max-width: 47.99rem)";
/** Moments of a smooth curve, per CSS px of its width. */
const DENSITY = 1;
/** Samples of each step of the solver. */
const PER_STEP = 4;
const HEIGHT = 210;

export function mountPlots(lab: Lab, place: HTMLElement): void {
  const view = new View(lab.motion);
  const palette = paletteOf(place);
  const chosen = signal(FIGURES[0]?.name);
  const narrow = signal(matchMedia(NARROW).matches);
  matchMedia(NARROW).addEventListener("change", (query) => (narrow.value = query.matches));
  const width = signal(0);

  const charts = FIGURES.map((figure) => new Chart(figure, () => palette.value));
  const absent = element("p", { class: "absent" }, "There is no motion to plot.");
  const hint = element(
    "p",
    { class: "hint" },
    "Drag across a plot to zoom, click to go to a time, double-click for the whole motion; " +
      "the wheel zooms too, once you have clicked or with Ctrl. Touch: one finger goes to a time, two zoom.",
  );
  const notes = element("div", { class: "notes" }, phaseKey(lab), hint);
  const grid = element("div", { class: "grid" }, ...charts.map((chart) => chart.root), notes);
  const present = element(
    "div",
    {},
    toolbar(lab, view),
    chooser(FIGURES, FIGURES[0]?.name ?? "", (name) => (chosen.value = name)),
    grid,
  );
  place.append(absent, present);

  const samples = computed(() => lab.motion.value?.samples(PER_STEP));
  const subject = computed((): Subject | undefined => {
    const motion = lab.motion.value;
    const all = samples.value;
    if (!motion || !all) return undefined;
    const { law, friction } = lab.setup.value;
    const ground = all.column("potential_energy").reduce((a, b) => Math.min(a, b), Infinity);
    return { motion, theory: lab.theory.value, law, friction, ground };
  });
  const visible = computed(() =>
    charts.filter((chart) => !narrow.value || chart.figure.name === chosen.value),
  );

  const draw = () => {
    const now = subject.value;
    const all = samples.value;
    if (!now || !all || width.value === 0) return;
    const shown = view.shown.value;
    const moments = sampled(now.motion, all, shown, Math.ceil(width.value * DENSITY));
    for (const chart of visible.value) {
      chart.resize(width.value, HEIGHT);
      chart.show(now, moments, shown);
    }
    tell();
  };
  const tell = () => {
    const moment = lab.moment.value;
    const { origin, from, to } = view.shown.value;
    const at = (lab.clock.time.value - origin - from) / (to - from);
    if (moment) for (const chart of visible.value) chart.tell(at, moment);
  };

  effect(() => {
    const there = lab.motion.value !== undefined;
    present.hidden = !there;
    absent.hidden = there;
    for (const chart of charts) chart.root.hidden = !visible.value.includes(chart);
  });
  oncePerPicture(() => [subject.value, view.shown.value, visible.value, width.value], draw);
  oncePerPicture(() => [lab.clock.time.value], tell);
  oncePerPicture(
    () => [palette.value],
    () => charts.forEach((chart) => chart.recolour()),
  );
  new ResizeObserver(() => {
    const shownFigure = visible.value[0]?.root;
    if (shownFigure) width.value = Math.floor(shownFigure.clientWidth);
  }).observe(grid);

  for (const chart of charts) {
    const timeAt = (part: number) => {
      const { from, to } = view.shown.value;
      return from + part * (to - from);
    };
    attachGestures(chart.pad, chart.root, {
      scrub(part) {
        lab.clock.pause();
        lab.clock.time.value = view.shown.value.origin + timeAt(part);
      },
      now() {
        const { origin, from, to } = view.shown.value;
        return (lab.clock.time.value - origin - from) / (to - from);
      },
      select: (range) => chart.select(range),
      zoomTo: ([from, to]) => view.show(timeAt(from), timeAt(to)),
      zoom: (factor, about) => view.zoom(factor, timeAt(about)),
      canZoomOut: () => !view.isWhole,
      reset: () => view.whole(),
    });
  }
}

/** Does something before the next picture is painted whenever signals have changed. */
function oncePerPicture(read: () => unknown, act: () => void): void {
  let waiting = false;
  effect(() => {
    read();
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      act();
    });
  });
}
