// One plot on the page: its head with the values at the time shown, and the curves.

import uPlot from "uplot";
import type { Moment, Moments } from "../core/motion";
import { element } from "../elements";
import { significant } from "../time/words";
import type { Figure, Line, Subject } from "./figures";
import { drawEvents, drawPhases } from "./marks";
import type { Palette } from "./palette";
import { powersOfTen, stretchText, tickTexts, timeLabel, timeUnit } from "./ticks";
import { type Values, thinned } from "./thinned";
import type { Stretch } from "./view";

/** More points than this are thinned before they are drawn. */
const MANY = 5000;
/** So many parts of the width has a curve that is thinned. */
const PARTS = 1200;

export class Chart {
  readonly root: HTMLElement;
  /** Where hands are felt. */
  readonly pad: HTMLElement;
  private readonly plot: uPlot;
  private readonly picture = element("div", { class: "picture", role: "img" });
  private readonly line = element("div", { class: "now-line" });
  private readonly title = element("strong");
  private readonly outputs: { line: Line; output: HTMLElement; entry: HTMLElement }[] = [];
  private shown: Stretch = { origin: 0, from: 0, to: 1 };
  private subject: Subject | undefined;
  /** What one of the unit shown is in the figure's unit: 1e-3 for milli. */
  private unit = { name: "", size: 1 };

  constructor(
    readonly figure: Figure,
    private readonly palette: () => Palette,
  ) {
    this.title.id = `plot-${figure.name}`;
    const key = element("span", { class: "key" }, ...figure.lines.map((line) => this.entry(line)));
    this.root = element(
      "figure",
      { class: "plot", tabindex: "-1", "aria-labelledby": this.title.id },
      element("figcaption", {}, this.title, key),
      this.picture,
    );
    this.plot = new uPlot(this.options(), [[], ...figure.lines.map(() => [])], this.picture);
    this.pad = this.plot.over;
    this.pad.append(this.line);
  }

  resize(width: number, height: number): void {
    if (width !== this.plot.width || height !== this.plot.height)
      this.plot.setSize({ width, height });
  }

  /** Draws a stretch of a motion through moments that cover it. */
  show(subject: Subject, moments: Moments, shown: Stretch): void {
    this.subject = subject;
    this.shown = shown;
    const x = moments.column("t").map((time) => time - shown.origin);
    let curves = this.figure.lines.map((line) => line.values(moments, subject));
    if (this.figure.stacked) curves = stacked(curves);
    this.unit = this.unitOf(curves);
    const { name } = this.unit;
    this.title.textContent = this.figure.title + (name === "" ? "" : `, ${name}`);
    const data = x.length > MANY ? thinned(x, curves, PARTS) : [x, ...curves];
    this.figure.lines.forEach((_, k) => {
      const drawn = Array.from(curves[k] ?? []).some((value) => value !== null);
      this.outputs[k]?.entry.toggleAttribute("hidden", !drawn || this.isNothing(k, curves));
    });
    this.plot.batch(() => {
      this.plot.setData(data as uPlot.AlignedData, false);
      this.plot.setScale("x", { min: shown.from, max: shown.to });
    });
    this.picture.setAttribute("aria-label", this.summary(curves));
  }

  /** Draws it again in other colours. */
  recolour(): void {
    this.plot.redraw(false);
  }

  /** Puts the line at a place, 0 to 1, and reads the values out. */
  tell(place: number, moment: Moment): void {
    const inside = place >= 0 && place <= 1;
    this.line.hidden = !inside;
    if (inside) this.line.style.transform = `translateX(${place * this.pad.clientWidth}px)`;
    for (const { line, output } of this.outputs) {
      const value = this.subject && line.now?.(moment, this.subject);
      output.textContent = value === undefined ? "" : this.valueText(value);
    }
  }

  select(range: [number, number] | undefined): void {
    const { clientWidth, clientHeight } = this.pad;
    const [a, b] = range ?? [0, 0];
    this.plot.setSelect(
      {
        left: Math.min(a, b) * clientWidth,
        width: Math.abs(a - b) * clientWidth,
        top: 0,
        height: range ? clientHeight : 0,
      },
      false,
    );
  }

  private entry(line: Line): HTMLElement {
    const output = element("span", { class: "value" });
    const swatch = element("i", {
      class: this.figure.stacked ? "area" : line.dash ? "dashed" : "",
      style: `--swatch: var(--${line.colour})`,
    });
    const entry = element("span", { class: "entry" }, swatch, `${line.label} `, output);
    this.outputs.push({ line, output, entry });
    return entry;
  }

  private valueText(value: number): string {
    if (Number.isNaN(value)) return "";
    if (!Number.isFinite(value)) return "∞";
    const text = significant(value / this.unit.size, 4);
    return this.unit.name === "°" ? `${text}°` : `${text} ${this.unit.name}`;
  }

  private unitOf(curves: readonly Values[]): { name: string; size: number } {
    const { unit, prefixed } = this.figure;
    if (!prefixed) return { name: unit, size: 1 };
    const [, most] = bounds(curves);
    if (most >= 1) return { name: unit, size: 1 };
    return most >= 1e-3 ? { name: `m${unit}`, size: 1e-3 } : { name: `µ${unit}`, size: 1e-6 };
  }

  /** Whether an area has no height anywhere. */
  private isNothing(index: number, curves: readonly Values[]): boolean {
    if (!this.figure.stacked || index === 0) return false;
    const [lower, upper] = [curves[index - 1] as Values, curves[index] as Values];
    return Array.from(upper).every((value, k) => value === lower[k]);
  }

  private summary(curves: readonly Values[]): string {
    const [least, most] = bounds(curves);
    const range =
      least > most
        ? "nothing to show"
        : `between ${this.valueText(least)} and ${this.valueText(most)}`;
    return `${this.figure.title} over time ${stretchText(this.shown)}: ${range}`;
  }

  private options(): uPlot.Options {
    const { figure } = this;
    const colour = (name: keyof Palette) => () => this.palette()[name];
    const axis = {
      stroke: colour("muted"),
      font: "12px system-ui, sans-serif",
      labelFont: "12px system-ui, sans-serif",
      grid: { stroke: colour("line"), width: 1 },
      ticks: { stroke: colour("line"), width: 1, size: 4 },
      gap: 4,
    };
    return {
      width: 320,
      height: 200,
      pxAlign: false,
      padding: [8, 12, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, auto: false },
        y: {
          distr: figure.stretched ? 4 : 1,
          range: (_, low, high) => this.range(low, high),
        },
      },
      axes: [
        {
          ...axis,
          space: 48,
          size: 24,
          label: () => timeLabel(this.shown),
          labelSize: 18,
          labelGap: 0,
          values: (_, places) => tickTexts(places, timeUnit(this.shown).size),
        } as uPlot.Axis,
        {
          ...axis,
          size: 58,
          space: 28,
          ...(figure.stretched && {
            splits: (plot: uPlot, _axis: number, low: number, high: number) =>
              powersOfTen(low, high, plot.bbox.height / devicePixelRatio / 22),
            filter: (_: uPlot, places: number[]) => places,
          }),
          values: (_, places) =>
            figure.stretched
              ? places.map((place) => significant(place, 1))
              : tickTexts(places, this.unit.size),
        },
      ],
      series: [{}, ...figure.lines.map((line) => this.series(line, colour))],
      ...(figure.stacked && {
        bands: figure.lines.slice(1).map((line, k) => ({
          series: [k + 2, k + 1] as [number, number],
          fill: () => this.palette()[line.colour],
        })),
      }),
      hooks: {
        drawClear: [
          (plot) =>
            this.subject && drawPhases(plot, this.subject.motion, this.shown, this.palette()),
        ],
        draw: [
          (plot) =>
            this.subject && drawEvents(plot, this.subject.motion, this.shown, this.palette()),
        ],
      },
    };
  }

  private series(line: Line, colour: (name: keyof Palette) => () => string): uPlot.Series {
    const areas = this.figure.stacked;
    const last = this.figure.lines.at(-1) === line;
    return {
      stroke: colour(areas ? "ink" : line.colour),
      width: areas ? (last ? 1.5 : 0) : 2,
      points: { show: false },
      spanGaps: false,
      ...(line.dash && { dash: line.dash }),
      ...(areas && this.figure.lines[0] === line && { fill: () => this.palette()[line.colour] }),
    };
  }

  /** From the least to the largest value in view, with some room. */
  private range(low: number | null, high: number | null): [number, number] {
    const { include, stretched, stacked: areas } = this.figure;
    let [least, most] = [low ?? 0, high ?? 1];
    if (include !== undefined) [least, most] = [Math.min(least, include), Math.max(most, include)];
    if (stretched) return [Math.min(least * 2, -1), Math.max(most * 2, 1)];
    const room = most > least ? (most - least) * 0.08 : Math.abs(most) * 0.1 || 1;
    const onFloor = include !== undefined && least >= include - 1e-6 * room;
    return [onFloor ? include : least - room, most + (areas ? room / 2 : room)];
  }
}

/** Each curve on those before it. */
function stacked(curves: readonly Values[]): Values[] {
  let below: Values | undefined;
  return curves.map((values) => {
    const lower = below;
    below = Array.from(values, (value, k) => (value ?? 0) + (lower?.[k] ?? 0));
    return below;
  });
}

function bounds(curves: readonly Values[]): [number, number] {
  let [least, most] = [Infinity, -Infinity];
  for (const values of curves)
    for (let k = 0; k < values.length; k++) {
      const value = values[k];
      if (value == null) continue;
      if (value < least) least = value;
      if (value > most) most = value;
    }
  return [least, most];
}
