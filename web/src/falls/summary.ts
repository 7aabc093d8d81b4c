// What is said of the flicks.

import type { Lab } from "../lab";
import { type Side, type Tally, tallyOf } from "./tally";

/** What is said of the flicks that are shown; while they are being made, only that they are. */
export function flickSummary(lab: Lab): string {
  const made = lab.flicksShown.value;
  if (made === undefined) return "";
  if (lab.flicking.value) return "Flicking it …";
  const shown = lab.flicks.value.slice(0, made);
  return shown.length === 0
    ? "This set-up cannot be flicked."
    : inWords(tallyOf(shown), shown.length);
}

/** The tally of so many flicks in a sentence. */
function inWords({ word, left, right, others }: Tally, made: number): string {
  const did = word === "toppled" ? "fell" : "came up";
  const of = (side: Side, name: string) => {
    if (side.count === 0) return `none ${did} to the ${name}`;
    const spread = side.count > 1 ? ` ± ${side.deviation.toFixed(1)}°` : "";
    return `${side.count} ${did} to the ${name} after ${side.mean.toFixed(1)}°${spread}`;
  };
  const rest = others > 0 ? `; ${others} did something else` : "";
  return `Of ${made} flick${made === 1 ? "" : "s"} ${of(left, "left")}, ${of(right, "right")}${rest}.`;
}
