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
