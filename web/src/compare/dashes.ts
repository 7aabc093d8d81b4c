// A path as dashes of equal length, each with the times of its ends.

export interface Dash {
  from: readonly [x: number, y: number];
  to: readonly [x: number, y: number];
  start: number;
  end: number;
}

/** Dashes along a path through points at increasing times. They are `length` long with gaps as long between them, or
 * longer if there would be more than `most`. */
export function dashesAlong(
  t: ArrayLike<number>,
  x: ArrayLike<number>,
  y: ArrayLike<number>,
  length: number,
  most: number,
): Dash[] {
  const along = new Float64Array(t.length);
  for (let k = 1; k < t.length; k++)
    along[k] = along[k - 1]! + Math.hypot(x[k]! - x[k - 1]!, y[k]! - y[k - 1]!);
  const whole = along[along.length - 1] ?? 0;
  const step = Math.max(length, whole / (2 * most));
  if (!(whole > 0) || !(step > 0)) return [];
  let k = 0;
  const at = (place: number) => {
    while (k < along.length - 2 && along[k + 1]! < place) k++;
    const width = along[k + 1]! - along[k]!;
    const part = width > 0 ? Math.min((place - along[k]!) / width, 1) : 0;
    const between = (of: ArrayLike<number>) => of[k]! + part * (of[k + 1]! - of[k]!);
    return { t: between(t), spot: [between(x), between(y)] as const };
  };
  const dashes: Dash[] = [];
  for (let n = 0; 2 * n * step < whole; n++) {
    const from = at(2 * n * step);
    const to = at(Math.min((2 * n + 1) * step, whole));
    dashes.push({ from: from.spot, to: to.spot, start: from.t, end: to.t });
  }
  return dashes;
}

/** How many dashes have begun at a time, the last one counted by its part. */
export function dashesUntil(dashes: readonly Dash[], time: number): number {
  let [low, high] = [0, dashes.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (dashes[middle]!.start <= time) low = middle + 1;
    else high = middle;
  }
  const last = dashes[low - 1];
  if (!last) return 0;
  const width = last.end - last.start;
  return low - 1 + (width > 0 ? Math.min((time - last.start) / width, 1) : 1);
}
