// Plots over a common time axis, linked to the time shown.

import { computed, effect, signal } from "@preact/signals-core";
import "uplot/dist/uPlot.min.css";
import { element } from "../elements";
import type { Lab } from "../lab";
import { Chart } from "./chart";
import { FIGURES, FLOOR, type Subject } from "./figures";
import { attachGestures } from "./gestures";
import { joined, sampled } from "./samples";
import { paletteOf } from "./palette";
import "./plots.css";
import { chooser, phaseKey, toolbar } from "./toolbar";
import type { Setup } from "../setup/setup";
import type { Simulation } from "../simulation";
import { View } from "./view";
import { inSight, inTurn, onceIdle, oncePerFrame } from "../timing";
import { words } from "../words/words";

/** On a page narrower than this, one plot is shown at a time. */
const NARROW = "(max-width: 47.99rem)";
/** Moments per CSS px of the width that make a smooth curve. */
const DENSITY = 1;
/** Height of a plot at the usual type size, CSS px. */
const HEIGHT = 210;

export function mountPlots(lab: Lab, section: HTMLElement): void {
  const view = new View(lab.motion, lab.end);
  const palette = paletteOf(section);
  const chosen = signal("tilt");
  const narrow = signal(matchMedia(NARROW).matches);
  matchMedia(NARROW).addEventListener("change", (query) => (narrow.value = query.matches));
  const width = signal(0);

  const large = parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;
  const charts = FIGURES.map((figure) => new Chart(figure, () => palette.value, large));
  const absent = element("p", { class: "absent" }, words.plots.absent);
  const hint = element("p", { class: "hint" }, words.plots.hint);
  const notes = element("div", { class: "notes" }, phaseKey(lab), hint);
  const grid = element("div", { class: "grid" }, ...charts.map((chart) => chart.root), notes);
  const present = element("div", {}, toolbar(lab, view), chooser(lab, FIGURES, chosen), grid);
  section.append(absent, present);

  const samples = computed(() => lab.motion.value?.curve());
  const subject = computed(() => subjectOf(lab.setup.value, lab));
  const other = computed(() => lab.otherSetup.value && subjectOf(lab.otherSetup.value, lab.other));
  const chosenCharts = computed(() =>
    charts.filter(
      ({ figure: { name } }) =>
        (lab.shaking.value || name !== FLOOR) && (!narrow.value || name === chosen.value),
    ),
  );
  // Plots out of sight are drawn later, when nothing has changed for a while, so that a slider redraws
  // only what is visible and screen readers still find current texts.
  const seen = inSight(charts.map((chart) => chart.root));
  const visible = computed(() => chosenCharts.value.filter(({ root }) => seen.value.has(root)));

  const lines = computed(() => {
    const [now, all, shown] = [subject.value, samples.value, view.shown.value];
    if (!now || !all || width.value === 0) return undefined;
    const density = Math.ceil(width.value * DENSITY);
    const mine = sampled(now.motion, all, shown, density);
    const others = other.value;
    const [moments, beside] = others
      ? joined(mine, sampled(others.motion, others.motion.curve(), shown, density))
      : [mine, undefined];
    return { now, moments, shown, other: others && beside && { subject: others, moments: beside } };
  });
  const draw = (chart: Chart) => {
    const drawn = lines.value;
    if (!drawn) return;
    chart.resize(width.value, Math.round(HEIGHT * large));
    chart.show(drawn.now, drawn.moments, drawn.shown, drawn.other);
    showMoment([chart]);
  };
  const showMoment = (these: readonly Chart[]) => {
    const moment = lab.moment.value;
    const place = view.placeOf(lab.clock.time.value);
    const beside = lab.otherMoment.value;
    if (moment) for (const chart of these) chart.showMoment(place, moment, beside);
  };

  effect(() => {
    const there = lab.motion.value !== undefined;
    present.hidden = !there;
    absent.hidden = there;
    for (const chart of charts) chart.root.hidden = !chosenCharts.value.includes(chart);
  });
  const drawn = () => [
    subject.value,
    other.value,
    view.shown.value,
    chosenCharts.value,
    width.value,
  ];
  const [drawVisible, drawAll] = [inTurn(draw), inTurn(draw)];
  oncePerFrame(
    () => [drawn(), visible.value],
    () => drawVisible(visible.value),
  );
  onceIdle(drawn, () => drawAll(chosenCharts.value));
  addEventListener("beforeprint", () => chosenCharts.value.forEach(draw));
  oncePerFrame(
    () => lab.clock.time.value,
    () => showMoment(visible.value),
  );
  onceIdle(
    () => lab.clock.time.value,
    () => showMoment(chosenCharts.value),
  );
  oncePerFrame(
    () => palette.value,
    () => charts.forEach((chart) => chart.recolour()),
  );
  new ResizeObserver(() => {
    const shownFigure = chosenCharts.value[0]?.root;
    if (shownFigure) width.value = Math.floor(shownFigure.clientWidth);
  }).observe(grid);

  for (const chart of charts) link(chart, lab, view);
}

/** The data of the figures for a set-up and its motion. */
function subjectOf(
  { law, friction }: Readonly<Setup>,
  of: Pick<Simulation, "motion" | "theory" | "shaking">,
): Subject | undefined {
  const motion = of.motion.value;
  if (!motion) return undefined;
  const potential = motion.curve().column("potential_energy");
  const ground = potential.reduce((a, b) => Math.min(a, b), Infinity);
  return { motion, theory: of.theory.value, law, friction, shaking: of.shaking.value, ground };
}

/** Connects the gestures on a plot to the clock and the view. */
function link(chart: Chart, { clock }: Lab, view: View): void {
  const timeAt = (place: number) => {
    const { from, to } = view.shown.value;
    return from + place * (to - from);
  };
  attachGestures(chart.pad, chart.root, {
    scrub(place) {
      clock.pause();
      clock.time.value = view.shown.value.origin + timeAt(place);
    },
    now: () => view.placeOf(clock.time.value),
    select: (range) => chart.select(range),
    zoomTo: ([from, to]) => view.show(timeAt(from), timeAt(to)),
    zoom: (factor, about) => view.zoom(factor, timeAt(about)),
    canZoomOut: () => !view.isWhole,
    reset: () => view.whole(),
  });
}
