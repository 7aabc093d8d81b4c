// One plot: a heading with the values at the time shown, and the curves.

import uPlot from "uplot";
import { countBelow, type Moment, type Moments, type Motion } from "../core/motion";
import { element } from "../elements";
import { formatFixed, significant } from "../format";
import { type Figure, finite, type Line, type Subject } from "./figures";
import type { Colour, Palette } from "./palette";
import { powersOfTen, powerText, stretchText, tickTexts, timeLabel, timeUnit } from "./ticks";
import { thinned, type Values } from "./samples";
import type { Stretch } from "./view";
import { say, words } from "../words/words";

/** Curves with more points per CSS px of the width than this are thinned. */
const MAX_DENSITY = 4;

export class Chart {
  readonly root: HTMLElement;
  /** The element that receives pointer events. */
  readonly pad: HTMLElement;
  private readonly plot: uPlot;
  /** The lines of the figure, and that of a second motion. */
  private readonly lines: readonly Line[];
  private readonly picture = element("div", { class: "picture", role: "img" });
  private readonly line = element("div", { class: "now-line" });
  private readonly title = element("strong");
  private readonly outputs: { line: Line; output: HTMLElement; entry: HTMLElement }[] = [];
  private shown: Stretch = { since: "start", origin: 0, from: 0, to: 1 };
  private subject: Subject | undefined;
  /** The data of a second motion. */
  private other: Subject | undefined;
  /** The unit shown and its size in the figure's unit: 1e-3 for milli. */
  private unit = { name: "", size: 1 };

  constructor(
    readonly figure: Figure,
    private readonly palette: () => Palette,
    /** Type size of the page over the usual one. */
    private readonly large: number,
  ) {
    this.title.id = `plot-${figure.name}`;
    // This title is shown until the plot comes into view and is drawn.
    this.title.textContent = figure.title;
    this.picture.setAttribute("aria-label", figure.title);
    this.lines = figure.other ? [...figure.lines, figure.other] : figure.lines;
    const key = element("span", { class: "key" }, ...this.lines.map((line) => this.entry(line)));
    this.root = element(
      "figure",
      { class: "plot", tabindex: "-1", "aria-labelledby": this.title.id },
      element("figcaption", {}, this.title, key),
      this.picture,
    );
    this.plot = new uPlot(this.options(), [[], ...this.lines.map(() => [])], this.picture);
    this.pad = this.plot.over;
    this.pad.append(this.line);
  }

  resize(width: number, height: number): void {
    if (width !== this.plot.width || height !== this.plot.height)
      this.plot.setSize({ width, height });
  }

  /** Draws a stretch of a motion through moments that cover it, and a second motion at the same times. */
  show(
    subject: Subject,
    moments: Moments,
    shown: Stretch,
    other?: { subject: Subject; moments: Moments },
  ): void {
    this.subject = subject;
    this.other = other?.subject;
    this.shown = shown;
    const x = moments.column("t").slice();
    for (let k = 0; k < x.length; k++) x[k] = (x[k] as number) - shown.origin;
    const own = this.figure.lines.map((line) => line.values(moments, subject));
    const lines = this.figure.stacked ? stacked(own) : own;
    if (this.figure.other)
      lines.push(
        other
          ? this.figure.other.values(other.moments, other.subject)
          : new Array<null>(x.length).fill(null),
      );
    const parts = Math.ceil(this.across);
    const data = x.length > MAX_DENSITY * parts ? thinned(x, lines, parts) : [x, ...lines];
    const curves = data.slice(1);
    this.unit = this.unitOf(curves);
    const { name } = this.unit;
    this.title.textContent = this.figure.title + (name === "" ? "" : `, ${name}`);
    this.outputs.forEach(({ entry }, k) => {
      entry.hidden = this.isEmpty(k, curves);
    });
    this.plot.batch(() => {
      this.plot.setData(data as uPlot.AlignedData, false);
      this.plot.setScale("x", { min: shown.from, max: shown.to });
    });
    this.picture.setAttribute("aria-label", this.summary(curves));
  }

  /** Draws the plot again in other colours. */
  recolour(): void {
    this.plot.redraw(false);
  }

  /** Moves the time line to a place, 0 to 1, and shows the values of a moment. */
  showMoment(place: number, moment: Moment, other?: Moment): void {
    const inside = place >= 0 && place <= 1;
    this.line.hidden = !inside;
    if (inside) this.line.style.transform = `translateX(${place * this.across}px)`;
    for (const { line, output } of this.outputs) {
      const isOther = line === this.figure.other;
      const [subject, now] = isOther ? [this.other, other] : [this.subject, moment];
      const value = subject && now && line.now?.(now, subject);
      output.textContent = value === undefined ? "" : this.valueText(value);
    }
  }

  /** Width of the curves, CSS px, taken from the plot to avoid a layout of the page. */
  private get across(): number {
    return this.plot.bbox.width / devicePixelRatio;
  }

  select(range: [number, number] | undefined): void {
    const [a, b] = range ?? [0, 0];
    this.plot.setSelect(
      {
        left: Math.min(a, b) * this.across,
        width: Math.abs(a - b) * this.across,
        top: 0,
        height: range ? this.plot.bbox.height / devicePixelRatio : 0,
      },
      false,
    );
  }

  private entry(line: Line): HTMLElement {
    const output = element("span", { class: "value" });
    const swatch = element("i", {
      class: this.isArea(line) ? "area" : line.dash ? "dashed" : "",
      style: `--swatch: var(--${line.colour})`,
    });
    const entry = element("span", { class: "entry" }, swatch, `${line.label} `, output);
    entry.hidden = line === this.figure.other;
    this.outputs.push({ line, output, entry });
    return entry;
  }

  /** Whether a line is the border of an area. */
  private isArea(line: Line | undefined): boolean {
    return this.figure.stacked === true && line !== this.figure.other;
  }

  private valueText(value: number): string {
    if (Number.isNaN(value)) return "";
    if (!Number.isFinite(value)) return "∞";
    const { name, size } = this.unit;
    // All energies are written with the same number of decimals.
    const text = this.figure.prefixed ? thousandths(value / size) : significant(value, 4);
    return name === "" || name === "°" ? text + name : `${text} ${name}`;
  }

  private unitOf(curves: readonly Values[]): { name: string; size: number } {
    const { unit, prefixed } = this.figure;
    if (!prefixed) return { name: unit, size: 1 };
    const [, max] = bounds(curves);
    if (max >= 1) return { name: unit, size: 1 };
    return max >= 1e-3 ? { name: `m${unit}`, size: 1e-3 } : { name: `µ${unit}`, size: 1e-6 };
  }

  /** Whether a line has no values or an area above the lowest has no height. */
  private isEmpty(index: number, curves: readonly Values[]): boolean {
    const [lower, values] = [curves[index - 1], curves[index] as Values];
    const floor = this.isArea(this.lines[index]) && lower ? lower : undefined;
    for (let k = 0; k < values.length; k++)
      if (values[k] != null && values[k] !== floor?.[k]) return false;
    return true;
  }

  private summary(curves: readonly Values[]): string {
    const [min, max] = bounds(curves);
    const range =
      min > max
        ? words.plots.nothing
        : say(words.plots.range, { low: this.valueText(min), high: this.valueText(max) });
    return say(words.plots.summary, {
      title: this.figure.title,
      stretch: stretchText(this.shown),
      range,
    });
  }

  private options(): uPlot.Options {
    const { figure } = this;
    const colour = (name: keyof Palette) => () => this.palette()[name];
    const { large } = this;
    // uPlot reads whole numbers only.
    const font = `${Math.round(12 * large)}px system-ui, sans-serif`;
    const axis = {
      stroke: colour("muted"),
      font,
      labelFont: font,
      grid: { stroke: colour("line"), width: 1 },
      ticks: { stroke: colour("line"), width: 1, size: 4 },
      gap: 4,
    };
    return {
      width: 320,
      height: 200,
      pxAlign: false,
      padding: [8 * large, 12 * large, 0, 0],
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
          space: 48 * large,
          size: 24 * large,
          label: () => timeLabel(this.shown),
          labelSize: 18 * large,
          labelGap: 0,
          values: (_, places) => tickTexts(places, timeUnit(this.shown).size),
        } as uPlot.Axis,
        {
          ...axis,
          size: 58 * large,
          space: 28 * large,
          ...(figure.stretched && {
            splits: (plot: uPlot, _axis: number, low: number, high: number) =>
              powersOfTen(low, high, plot.bbox.height / devicePixelRatio / large),
            filter: (_: uPlot, places: number[]) => places,
          }),
          values: (_, places) =>
            figure.stretched ? places.map(powerText) : tickTexts(places, this.unit.size),
        },
      ],
      series: [{}, ...this.lines.map((line) => this.series(line, colour))],
      ...(figure.stacked && {
        bands: figure.lines.slice(1).map((line, k) => ({
          series: [k + 2, k + 1] as [number, number],
          fill: () => this.palette()[line.colour],
        })),
      }),
      hooks: {
        drawClear: [(plot) => this.mark(plot, shadePhases)],
        draw: [
          (plot) => {
            this.mark(plot, drawStrip);
            this.mark(plot, drawEvents);
          },
        ],
      },
    };
  }

  private mark(plot: uPlot, draw: Mark): void {
    if (this.subject) draw(plot, this.subject.motion, this.shown, this.palette());
  }

  private series(line: Line, colour: (name: keyof Palette) => () => string): uPlot.Series {
    const areas = this.isArea(line);
    const last = this.figure.lines.at(-1) === line;
    return {
      stroke: colour(areas ? "ink" : line.colour),
      width: areas ? (last ? 1.5 : 0) : (line.width ?? 2),
      points: { show: false },
      spanGaps: false,
      ...(line.dash && { dash: line.dash }),
      ...(areas && this.figure.lines[0] === line && { fill: () => this.palette()[line.colour] }),
    };
  }

  /** From the smallest to the largest value in view, with a margin. */
  private range(low: number | null, high: number | null): [number, number] {
    const { include, stretched, stacked: areas } = this.figure;
    let [min, max] = [low ?? 0, high ?? 1];
    if (include !== undefined) [min, max] = [Math.min(min, include), Math.max(max, include)];
    if (stretched) return [Math.min(min * 2, -1), Math.max(max * 2, 1)];
    const room = max > min ? (max - min) * 0.08 : Math.abs(max) * 0.1 || 1;
    const onFloor = include !== undefined && min >= include - 1e-6 * room;
    return [onFloor ? include : min - room, max + (areas ? room / 2 : room)];
  }
}

/** Adds each curve to the sum of those before it. */
function stacked(curves: readonly Values[]): Values[] {
  let below: Float64Array | undefined;
  return curves.map((values) => {
    const sum = new Float64Array(values.length);
    for (let k = 0; k < sum.length; k++) sum[k] = (values[k] ?? 0) + (below?.[k] ?? 0);
    below = sum;
    return finite(sum);
  });
}

function bounds(curves: readonly Values[]): [number, number] {
  let [min, max] = [Infinity, -Infinity];
  for (const values of curves)
    for (let k = 0; k < values.length; k++) {
      const value = values[k];
      if (value == null) continue;
      if (value < min) min = value;
      if (value > max) max = value;
    }
  return [min, max];
}

/** A number with three decimals; zero has no sign. */
const thousandths = (value: number) => formatFixed(Math.round(1000 * value) / 1000 || 0, 3);

// Marks on a plot: phases of the motion behind the curves and events on the time axis.

const PHASES: Record<string, Colour> = {
  rolling: "rolling",
  sliding: "sliding",
  flying: "flying",
  standing: "plot-fourth",
  sliding_flat: "sliding",
  flying_level: "flying",
  lying: "muted",
};

/** Events with a tick and its colour. */
const EVENTS: Record<string, Colour> = {
  tilt_min: "ink",
  slip: "sliding",
  stick: "rolling",
  lift_off: "flying",
  land: "flying",
  uplift: "rolling",
  stand: "plot-fourth",
  face_down: "warn",
  topple: "warn",
};

const SHADE = 0.13;
const STRIP = 4;
const TICK = 9;
/** If more events than this are in view, their ticks are smaller. */
const MANY = 40;

/** Draws something besides the curves. */
export type Mark = (plot: uPlot, motion: Motion, shown: Stretch, palette: Palette) => void;

/** Shades the phases behind the curves. */
export const shadePhases: Mark = (plot, motion, shown, palette) =>
  fillPhases(plot, motion, shown, palette, SHADE, plot.bbox.height);

/** Draws the phases as a strip along the top, in full colour. */
export const drawStrip: Mark = (plot, motion, shown, palette) =>
  fillPhases(plot, motion, shown, palette, 1, STRIP * devicePixelRatio);

function fillPhases(
  plot: uPlot,
  motion: Motion,
  shown: Stretch,
  palette: Palette,
  opacity: number,
  height: number,
): void {
  const { ctx, bbox } = plot;
  const x = abscissa(plot, shown);
  const starts = motion.phases.map((phase) => phase.start);
  ctx.save();
  ctx.globalAlpha = opacity;
  for (let k = Math.max(countBelow(starts, shown.origin + shown.from) - 1, 0); ; k++) {
    const phase = motion.phases[k];
    if (!phase || phase.start > shown.origin + shown.to) break;
    ctx.fillStyle = palette[PHASES[phase.kind] ?? "muted"];
    ctx.fillRect(x(phase.start), bbox.top, x(phase.end) - x(phase.start), height);
  }
  ctx.restore();
}

/** Draws a tick on the time axis for each event. */
export const drawEvents: Mark = (plot, motion, shown, palette) => {
  const { ctx, bbox } = plot;
  const x = abscissa(plot, shown);
  const bottom = bbox.top + bbox.height;
  ctx.save();
  ctx.lineWidth = 1.5 * devicePixelRatio;
  const inView = motion.events.filter(({ moment: { t } }) => {
    const since = t - shown.origin;
    return since >= shown.from && since <= shown.to;
  });
  const height = (inView.length > MANY ? TICK / 2 : TICK) * devicePixelRatio;
  for (const { kind, moment } of inView) {
    const colour = EVENTS[kind];
    if (!colour) continue;
    ctx.strokeStyle = palette[colour];
    ctx.beginPath();
    ctx.moveTo(x(moment.t), bottom);
    ctx.lineTo(x(moment.t), bottom - height);
    ctx.stroke();
  }
  ctx.restore();
};

/** Converts a time (s) to a canvas pixel within the plot. */
function abscissa({ bbox }: uPlot, { origin, from, to }: Stretch): (time: number) => number {
  return (time) =>
    bbox.left + bbox.width * Math.min(Math.max((time - origin - from) / (to - from), 0), 1);
}
