// Labels of the axes.

import {
  formatDuration,
  formatNumber,
  significant,
  SUPERSCRIPTS,
  type TimeUnit,
  unitFor,
  written,
} from "../format";
import type { Stretch } from "./view";
import { say, words } from "../words/words";

/** The unit for the times of a stretch. */
export function timeUnit({ from, to }: Stretch): TimeUnit {
  return unitFor(Math.max(Math.abs(from), Math.abs(to)) * 0.5);
}

export function timeLabel(shown: Stretch): string {
  const { name } = timeUnit(shown);
  return shown.since === "start"
    ? say(words.plots.timeLabel, { unit: name })
    : say(words.plots.since, { unit: name, origin: originText(shown) });
}

function originText({ since, origin }: Stretch): string {
  return since === "collision"
    ? say(words.plots.collisionAt, { time: `${significant(origin, 6)} s` })
    : `${formatNumber(origin, 12)} s`;
}

/** Values of an axis in a unit, with the digits that distinguish them. */
export function tickTexts(places: readonly number[], unit: number): string[] {
  const step = Math.abs((places[1] ?? 1) - (places[0] ?? 0)) / unit;
  let digits = 0;
  while (digits < 12 && Math.abs(step * 10 ** digits - Math.round(step * 10 ** digits)) > 1e-3)
    digits++;
  return places.map((place) => {
    const text = (place / unit).toFixed(digits);
    return Number(text) === 0 ? "0" : written(text);
  });
}

/** A stretch in words. */
export function stretchText(shown: Stretch): string {
  const { since, from, to } = shown;
  const stretch = say(words.plots.stretch, { from: formatDuration(from), to: formatDuration(to) });
  return since === "start"
    ? stretch
    : say(words.plots.about, { stretch, origin: originText(shown) });
}

/** Smallest distance between labels, CSS px. */
const MIN_GAP = 18;

/** Zero and powers of ten of both signs, for an arsinh axis of a length in CSS px. */
export function powersOfTen(low: number, high: number, length: number): number[] {
  const scale = length / (Math.asinh(high) - Math.asinh(low));
  const every = Math.max(Math.ceil(MIN_GAP / (Math.LN10 * scale)), 1);
  const ticks = [0];
  const largest = Math.floor(Math.log10(Math.max(-low, high)) + 1e-9);
  for (let k = largest; Math.asinh(10 ** k) * scale >= MIN_GAP; k -= every)
    ticks.push(10 ** k, -(10 ** k));
  return ticks.filter((tick) => tick >= low && tick <= high).sort((a, b) => a - b);
}

/** A power of ten, written with an exponent if it is large. */
export function powerText(value: number): string {
  if (Math.abs(value) < 1e4) return written(String(value));
  const size = [...String(Math.round(Math.log10(Math.abs(value))))];
  return `${value < 0 ? "−" : ""}10${size.map((digit) => SUPERSCRIPTS[Number(digit)]).join("")}`;
}
