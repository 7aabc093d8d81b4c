// How axes are labelled.

import { duration, signed, significant, unitFor, type TimeUnit } from "../time/words";
import type { Stretch } from "./view";

/** The unit in which the times of a stretch are written. */
export function timeUnit({ from, to }: Stretch): TimeUnit {
  return unitFor(Math.max(Math.abs(from), Math.abs(to)) * 0.5);
}

export function timeLabel(shown: Stretch): string {
  const { name } = timeUnit(shown);
  if (shown.origin === 0) return `time, ${name}`;
  return `${name} from the collision at ${significant(shown.origin, 6)} s`;
}

/** Places of an axis in a unit, with no more digits than tell them apart. */
export function tickTexts(places: readonly number[], unit: number): string[] {
  const step = Math.abs((places[1] ?? 1) - (places[0] ?? 0)) / unit;
  let digits = 0;
  while (digits < 12 && Math.abs(step * 10 ** digits - Math.round(step * 10 ** digits)) > 1e-3)
    digits++;
  return places.map((place) => {
    const text = (place / unit).toFixed(digits);
    return Number(text) === 0 ? "0" : signed(text);
  });
}

/** What a stretch is, in words. */
export function stretchText(shown: Stretch): string {
  const { origin, from, to } = shown;
  if (origin === 0) return `from ${duration(from)} to ${duration(to)}`;
  return `from ${signed(duration(from))} to ${duration(to)} about the collision at ${significant(origin, 6)} s`;
}

/** Powers of ten, both signs and zero, for an axis on which small values are drawn larger. */
export function powersOfTen(low: number, high: number, most: number): number[] {
  const size = Math.max(Math.abs(low), Math.abs(high), 1);
  const decades = Math.floor(Math.log10(size) + 1e-9);
  const every = Math.max(Math.ceil((2 * decades + 1) / Math.max(most, 3)), 1);
  const ticks = [0];
  for (let k = decades; k >= 0; k -= every) ticks.push(10 ** k, -(10 ** k));
  return ticks.filter((tick) => tick >= low && tick <= high).sort((a, b) => a - b);
}
