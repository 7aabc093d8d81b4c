// The moments through which a plot is drawn.

import { type Column, countBelow, Moments, type Motion } from "../core/motion";
import type { Stretch } from "./view";

/** `all` are the samples of the motion; the result has at least `minimum` moments. */
export function sampled(
  motion: Motion,
  all: Moments,
  { origin, from, to }: Stretch,
  minimum: number,
): Moments {
  const times = all.column("t");
  let first = countBelow(times, origin + from);
  let last = countBelow(times, origin + to);
  if (last - first < minimum) {
    const even = motion.at(
      evenly(minimum, (k) => origin + from + ((to - from) * k) / (minimum - 1)),
    );
    return merged(all, first, last, even);
  }
  // Keep one moment beyond each end, so that the lines reach the border of the plot.
  [first, last] = [Math.max(first - 1, 0), Math.min(last + 1, all.length)];
  return last - first === all.length ? all : part(all, first, last);
}

const evenly = (length: number, of: (index: number) => number) =>
  Float64Array.from({ length }, (_, k) => of(k));

function part(moments: Moments, first: number, last: number): Moments {
  const length = last - first;
  const numbers = new Float64Array(length * moments.names.length);
  moments.names.forEach((name, c) =>
    numbers.set(moments.column(name).subarray(first, last), c * length),
  );
  return new Moments(moments.names, numbers);
}

/** Merges a part of some moments with all of others, in the order of time. */
function merged(some: Moments, first: number, last: number, others: Moments): Moments {
  const [t, other] = [some.column("t"), others.column("t")];
  const length = last - first + others.length;
  const numbers = new Float64Array(length * some.names.length);
  // Indices of the first moments count up from 0, those of the second down from −1.
  const places = new Int32Array(length);
  for (let k = 0, i = first, j = 0; k < length; k++) {
    const mine = j >= others.length || (i < last && (t[i] as number) <= (other[j] as number));
    places[k] = mine ? i++ : -1 - j++;
  }
  some.names.forEach((name, c) => {
    const [mine, theirs] = [some.column(name), others.column(name)];
    for (let k = 0; k < length; k++) {
      const place = places[k] as number;
      numbers[c * length + k] = (place < 0 ? theirs[-1 - place] : mine[place]) as number;
    }
  });
  return new Moments(some.names, numbers);
}

// Two motions at the same times, so that one plot can draw both.

/** Both motions at the times of both, linearly interpolated between their own moments, as a plot draws them; NaN
 * before the first and after the last of these. */
export function joined(a: Moments, b: Moments): [Moments, Moments] {
  const [s, t] = [a.column("t"), b.column("t")];
  const length = s.length + t.length;
  const times = new Float64Array(length);
  // Places of the times among the moments of each motion, with fractions between moments.
  const [inA, inB] = [new Float64Array(length), new Float64Array(length)];
  for (let k = 0, i = 0, j = 0; k < length; k++) {
    const mine = j >= t.length || (i < s.length && s[i]! <= t[j]!);
    const time = mine ? s[i]! : t[j]!;
    times[k] = time;
    inA[k] = mine ? i : placeBefore(s, i, time);
    inB[k] = mine ? placeBefore(t, j, time) : j;
    if (mine) i++;
    else j++;
  }
  return [at(a, inA, times), at(b, inB, times)];
}

/** The fractional place of a time before the moment `next`; NaN outside the moments. */
function placeBefore(times: Float64Array, next: number, time: number): number {
  if (next >= times.length) return times[times.length - 1] === time ? times.length - 1 : NaN;
  if (next === 0) return times[0] === time ? 0 : NaN;
  const [from, to] = [times[next - 1]!, times[next]!];
  return next - 1 + (to > from ? (time - from) / (to - from) : 1);
}

function at(moments: Moments, places: Float64Array, times: Float64Array): Moments {
  const { names } = moments;
  const numbers = new Float64Array(names.length * places.length);
  names.forEach((name: Column, c) => {
    const column = moments.column(name);
    for (let k = 0; k < places.length; k++) {
      const place = places[k]!;
      const low = Math.floor(place);
      const part = place - low;
      const from = column[low] ?? NaN;
      // Between two infinite values nothing is interpolated.
      const value = part > 0 ? from + part * (column[low + 1]! - from) : from;
      numbers[c * places.length + k] = name === "t" ? times[k]! : value;
    }
  });
  return new Moments(names, numbers);
}

// Thins a curve: a screen shows only the smallest and the largest value in a pixel.

export type Values = ArrayLike<number | null>;

/** Curves over x that keep the extremes of each curve in each of `parts` equal intervals of x. */
export function thinned(x: Float64Array, curves: readonly Values[], parts: number): Values[] {
  const [start, end] = [x[0] as number, x[x.length - 1] as number];
  const kept: number[] = [];
  for (let k = 0; k < x.length;) {
    const part = Math.floor((((x[k] as number) - start) / (end - start)) * parts);
    const bound = start + ((part + 1) * (end - start)) / parts;
    let next = k + 1;
    while (next < x.length && (x[next] as number) < bound) next++;
    if (next - k > 2) kept.push(...extremes(curves, k, next));
    else for (; k < next; k++) kept.push(k);
    k = next;
  }
  return [x, ...curves].map((values) => kept.map((k) => values[k] as number | null));
}

/** Indices of the smallest and largest value of each curve in a range, and of its ends. */
function extremes(curves: readonly Values[], from: number, to: number): number[] {
  const places = [from, to - 1];
  for (const values of curves) {
    let [lowest, highest] = [from, from];
    let [low, high] = [Infinity, -Infinity];
    for (let k = from; k < to; k++) {
      const value = values[k];
      if (value == null) continue;
      if (value < low) [low, lowest] = [value, k];
      if (value > high) [high, highest] = [value, k];
    }
    places.push(lowest, highest);
  }
  return [...new Set(places)].sort((a, b) => a - b);
}
