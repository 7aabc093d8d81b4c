// Falls that a visitor measured, as directions in degrees anticlockwise from the initial lean: above 180 on the left of the hand.

import { type Tally, tallyOf } from "./tally";

/** As many as a link holds. */
const MOST = 600;

/** Directions as a link has them: numbers with at most one decimal, between underscores. */
export const FALLS_PATTERN = String.raw`([0-9]{1,3}(\.[0-9])?(_[0-9]{1,3}(\.[0-9])?){0,${MOST - 1}})?`;

export const fallsInLink = (directions: readonly number[]): string =>
  directions
    .slice(0, MOST)
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
