// What many flicks came to: how many fell left and right, and how far round.

import type { Flick } from "./flicks";

/** The falls of one side; how far round they came, in degrees, whichever way round. */
export interface Side {
  turns: number[];
  count: number;
  mean: number;
  deviation: number;
}

export interface Tally {
  /** What the body did more often, and what is counted: `toppled`, or `rocked` up again. */
  word: "toppled" | "rocked";
  /** Where those that are counted lie, degrees: from 180 on to the left, below it to the right. */
  directions: number[];
  left: Side;
  right: Side;
  /** How many came to something else. */
  others: number;
}

const DEGREES = 180 / Math.PI;

/** Counts as rimroll.experiment does: falls if they are the more, else tilt maxima. */
export function tallyOf(flicks: readonly Flick[]): Tally {
  const of = (outcome: string) => flicks.filter((flick) => flick.outcome === outcome);
  const word = of("toppled").length >= of("rocked").length ? "toppled" : "rocked";
  const counted = of(word);
  const directions = counted.map(({ direction }) => direction * DEGREES);
  const turnsWhere = (here: (direction: number) => boolean) =>
    counted
      .filter(({ direction }) => here(direction * DEGREES))
      .map(({ turn }) => Math.abs(turn) * DEGREES);
  return {
    word,
    directions,
    left: side(turnsWhere((direction) => direction >= 180)),
    right: side(turnsWhere((direction) => direction < 180)),
    others: flicks.length - counted.length,
  };
}

function side(turns: number[]): Side {
  const count = turns.length;
  const mean = turns.reduce((sum, turn) => sum + turn, 0) / count;
  const squares = turns.reduce((sum, turn) => sum + (turn - mean) ** 2, 0);
  return { turns, count, mean, deviation: Math.sqrt(squares / (count - 1)) };
}
