// Behind and across the curves: how the body moves in each phase, and when something happens.

import type uPlot from "uplot";
import type { Motion } from "../core/motion";
import type { Colour, Palette } from "./palette";
import { countBelow } from "./sampled";
import type { Stretch } from "./view";

const PHASES: Record<string, Colour> = { rolling: "rolling", sliding: "sliding", flying: "flying" };

/** Which events get a tick, and its colour. */
const EVENTS: Record<string, Colour> = {
  tilt_min: "ink",
  slip: "sliding",
  stick: "rolling",
  lift_off: "flying",
  land: "flying",
  face_down: "warn",
  topple: "warn",
};

const SHADE = 0.13;
const STRIP = 4;
const TICK = 9;

/** Shades the phases, with a strip of the full colour on top. */
export function drawPhases(plot: uPlot, motion: Motion, shown: Stretch, palette: Palette): void {
  const { ctx, bbox } = plot;
  const x = abscissa(plot, shown);
  ctx.save();
  const starts = motion.phases.map((phase) => phase.start);
  for (let k = Math.max(countBelow(starts, shown.origin + shown.from) - 1, 0); ; k++) {
    const phase = motion.phases[k];
    if (!phase || phase.start > shown.origin + shown.to) break;
    ctx.fillStyle = palette[PHASES[phase.kind] ?? "muted"];
    const [left, right] = [x(phase.start), x(phase.end)];
    ctx.globalAlpha = SHADE;
    ctx.fillRect(left, bbox.top, right - left, bbox.height);
    ctx.globalAlpha = 1;
    ctx.fillRect(left, bbox.top, right - left, STRIP * devicePixelRatio);
  }
  ctx.restore();
}

/** Ticks up from the axis of time. */
export function drawEvents(plot: uPlot, motion: Motion, shown: Stretch, palette: Palette): void {
  const { ctx, bbox } = plot;
  const x = abscissa(plot, shown);
  const bottom = bbox.top + bbox.height;
  ctx.save();
  ctx.lineWidth = 1.5 * devicePixelRatio;
  for (const { kind, moment } of motion.events) {
    const colour = EVENTS[kind];
    const since = moment.t - shown.origin;
    if (!colour || since < shown.from || since > shown.to) continue;
    ctx.strokeStyle = palette[colour];
    ctx.beginPath();
    ctx.moveTo(x(moment.t), bottom);
    ctx.lineTo(x(moment.t), bottom - TICK * devicePixelRatio);
    ctx.stroke();
  }
  ctx.restore();
}

/** From a time (s) to a canvas pixel within the plot. */
function abscissa({ bbox }: uPlot, { origin, from, to }: Stretch): (time: number) => number {
  return (time) =>
    bbox.left + bbox.width * Math.min(Math.max((time - origin - from) / (to - from), 0), 1);
}
