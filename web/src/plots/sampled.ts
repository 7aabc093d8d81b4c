// The moments through which a plot is drawn: the solver steps, and additional equally spaced moments
// where the steps are too few for a smooth curve.

import { type Motion, Moments } from "../core/motion";
import { countBelow } from "../rising";
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
