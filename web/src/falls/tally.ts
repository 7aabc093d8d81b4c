// Counts the flicks that fell to the left and to the right, and averages their angles of turn.

import type { Flick } from "./flicks";

/** The falls to one side, with the sizes of their angles of turn in degrees. */
export interface Side {
  turns: number[];
  count: number;
  mean: number;
  deviation: number;
}

export interface Tally {
  /** The counted outcome, which is the more frequent: `toppled`, or `rocked` up again. */
  outcome: "toppled" | "rocked";
  /** Directions of the counted falls, degrees: from 180 to the left, below 180 to the right. */
  directions: number[];
  left: Side;
  right: Side;
  /** Number of flicks with another outcome. */
  others: number;
}

const DEGREES = 180 / Math.PI;

/** Counts as rimroll.experiment does: falls, or tilt maxima if these are more frequent. */
export function tallyOf(flicks: readonly Flick[]): Tally {
  const of = (outcome: string) => flicks.filter((flick) => flick.outcome === outcome);
  const outcome = of("toppled").length >= of("rocked").length ? "toppled" : "rocked";
  const counted = of(outcome);
  const directions = counted.map(({ direction }) => direction * DEGREES);
  const turnsWhere = (here: (direction: number) => boolean) =>
    counted
      .filter(({ direction }) => here(direction * DEGREES))
      .map(({ turn }) => Math.abs(turn) * DEGREES);
  return {
    outcome,
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
