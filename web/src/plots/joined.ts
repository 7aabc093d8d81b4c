// Two motions at the same times, so that one plot can draw both.

import { type Column, Moments } from "../core/motion";

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
