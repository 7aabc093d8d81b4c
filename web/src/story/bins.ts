// The axis of a straight histogram of angles of turn, which contains the limits of theory.

import type { Theory } from "../core/core";

/** A range divided into bins, degrees. */
export interface Bins {
  from: number;
  to: number;
  width: number;
}

/** Numbers of falls in each bin and beyond the ends of the axis. */
export interface Counts {
  below: number;
  bins: number[];
  above: number;
}

/** Margin beyond the limits and unit to which the ends are rounded, degrees. */
const [ROOM, ROUND] = [7, 5];
/** More bins than this could not be distinguished. */
const MAX_BINS = 60;
/** Percentage of the falls that may lie beyond the axis at either end. */
const MAX_OUTSIDE = 5;

/** An axis that contains the limits and nearly all of the turns (degrees, without sign). */
export function binsFor(theory: Theory | undefined, turns: readonly number[]): Bins {
  const limits = limitsOf(theory);
  const sorted = [...turns].sort((a, b) => a - b);
  const stray = Math.floor((sorted.length * MAX_OUTSIDE) / 100);
  const usual = sorted.slice(stray, sorted.length - stray);
  const held = [...limits.map((limit) => limit - ROOM), ...limits.map((limit) => limit + ROOM)];
  const ends = [...held, ...usual.slice(0, 1), ...usual.slice(-1)];
  if (ends.length === 0) return { from: 180, to: 180 + MAX_BINS, width: 1 };
  const from = ROUND * Math.floor(Math.min(...ends) / ROUND);
  const to = ROUND * Math.ceil((Math.max(...ends) + 1e-9) / ROUND);
  const width = [1, 2, 5, 10].find((width) => to - from <= MAX_BINS * width) ?? 20;
  // The range is a whole number of bins.
  return { from, to: from + width * Math.ceil((to - from) / width), width };
}

/** Limiting turns under the two ideal laws, degrees. */
export const limitsOf = (theory: Theory | undefined): number[] =>
  theory
    ? [theory.noSlip, theory.frictionless]
        .filter((limit) => !Number.isNaN(limit))
        .map((limit) => (limit * 180) / Math.PI)
    : [];

/** Counts the turns in bins that include their lower end but not their upper one. */
export function binned(turns: readonly number[], { from, to, width }: Bins): Counts {
  const bins = new Array<number>(Math.round((to - from) / width)).fill(0);
  let [below, above] = [0, 0];
  for (const turn of turns) {
    if (turn < from) below++;
    else if (turn >= to) above++;
    else bins[Math.floor((turn - from) / width)]! += 1;
  }
  return { below, bins, above };
}
