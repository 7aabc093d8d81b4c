// Falls to the left and to the right, counted: those of flicks, those that a visitor typed, and those of the paper.

import { MOST_FALLS } from "../setup/fields";
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

// Falls that a visitor measured, as directions in degrees anticlockwise from the initial lean: above 180 on the left of the hand.

export const fallsInLink = (directions: readonly number[]): string =>
  directions
    .slice(0, MOST_FALLS)
    .map((direction) => String(Math.round(10 * direction) / 10))
    .join("_");

export const fallsFromLink = (text: string): number[] =>
  text === "" ? [] : text.split("_").map(Number);

/** Reads directions that were typed, and those in links of other groups. Undefined if there are none or one is not from 0 to
 * 360. */
export function fallsTyped(text: string): number[] | undefined {
  const linked = [...text.matchAll(/[#&]falls=([\d._]+)/g)].flatMap(([, falls = ""]) =>
    fallsFromLink(falls),
  );
  const rest = text.replace(/\S*[#&]\S*/g, " ");
  const typed = rest
    .split(/[\s;°]+|,\s+/)
    .filter((word) => word !== "")
    .map((word) => Number(word.replace(",", ".")));
  const all = [...linked, ...typed];
  const areValid = all.every((direction) => direction >= 0 && direction <= 360);
  return all.length > 0 && areValid ? all : undefined;
}

/** Counts directions as if they were flicks that fell. */
export const tallyOfFalls = (directions: readonly number[]): Tally =>
  tallyOf(
    directions.map((direction) => ({
      outcome: "toppled",
      turn: ((direction >= 180 ? direction : 360 - direction) * Math.PI) / 180,
      direction: (direction * Math.PI) / 180,
    })),
  );

// Measurements of the paper.

/** Mean turn and standard deviation of each side, degrees, for 42 flicks of the paper's can (Srinivasan
 * & Ruina 2007), of which as many are taken to have fallen to the left as to the right. */
export const MEASURED = {
  left: { mean: 213.0, deviation: 3.9, count: 21 },
  right: { mean: 217.9, deviation: 4.5, count: 21 },
} as const;
