// Marks on a plot: phases of the motion behind the curves and events on the time axis.

import type uPlot from "uplot";
import type { Motion } from "../core/motion";
import type { Colour, Palette } from "./palette";
import { countBelow } from "../rising";
import type { Stretch } from "./view";

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
