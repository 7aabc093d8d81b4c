// Fewer points than moments: a screen shows no more than the least and the largest value in a pixel.

export type Values = ArrayLike<number | null>;

/** The same curves over x through the extremes of each in `parts` even parts of x. */
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

/** Where each curve is least and largest from one place up to another, and the first and last. */
function extremes(curves: readonly Values[], from: number, to: number): number[] {
  const places = [from, to - 1];
  for (const values of curves) {
    let [least, most] = [from, from];
    let [low, high] = [Infinity, -Infinity];
    for (let k = from; k < to; k++) {
      const value = values[k];
      if (value == null) continue;
      if (value < low) [low, least] = [value, k];
      if (value > high) [high, most] = [value, k];
    }
    places.push(least, most);
  }
  return [...new Set(places)].sort((a, b) => a - b);
}
