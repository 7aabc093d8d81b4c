// What many flicks came to: how many fell left and right, and how far round.

import type { Flicked } from "../lab";

/** The falls of one side, turns in degrees. */
export interface Side {
  count: number;
  mean: number;
  deviation: number;
}

export interface Tally {
  /** What the body did more often, and what is counted: `toppled`, or `rocked` up again. */
  word: "toppled" | "rocked";
  /** Turns counted, degrees: from 180 on to the left, below it to the right. */
  directions: number[];
  left: Side;
  right: Side;
  /** How many came to something else. */
  others: number;
}

const DEGREES = 180 / Math.PI;

/** Counts as rimroll.experiment does: falls if they are the more, else tilt maxima. */
export function tallied(flicks: readonly Flicked[]): Tally {
  const of = (outcome: string) => flicks.filter((flick) => flick.outcome === outcome);
  const word = of("toppled").length >= of("rocked").length ? "toppled" : "rocked";
  const directions = of(word).map((flick) => flick.direction * DEGREES);
  return {
    word,
    directions,
    left: side(directions.filter((d) => d >= 180)),
    right: side(directions.filter((d) => d < 180).map((d) => 360 - d)),
    others: flicks.length - directions.length,
  };
}

function side(turns: number[]): Side {
  const count = turns.length;
  const mean = turns.reduce((sum, turn) => sum + turn, 0) / count;
  const squares = turns.reduce((sum, turn) => sum + (turn - mean) ** 2, 0);
  return { count, mean, deviation: Math.sqrt(squares / (count - 1)) };
}

/** The tally in a sentence. */
export function inWords({ word, left, right, others }: Tally, made: number): string {
  if (made === 0) return "";
  const did = word === "toppled" ? "fell" : "came up";
  const told = (side: Side, name: string) => {
    if (side.count === 0) return `none ${did} to the ${name}`;
    const spread = side.count > 1 ? ` ± ${side.deviation.toFixed(1)}°` : "";
    return `${side.count} ${did} to the ${name} after ${side.mean.toFixed(1)}°${spread}`;
  };
  const rest = others > 0 ? `; ${others} did something else` : "";
  return `Of ${made} flicks ${told(left, "left")}, ${told(right, "right")}${rest}.`;
}
