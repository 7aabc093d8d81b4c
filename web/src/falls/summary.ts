// Summarises the flicks in a sentence.

import type { Lab } from "../lab";
import { type Side, type Tally, tallyOf } from "./tally";

/** A sentence on the flicks that are shown, or a notice while they are still appearing. */
export function flickSummary(lab: Lab): string {
  const count = lab.flicksShown.value;
  if (count === undefined) return "";
  if (lab.flicking.value) return "Flicking it …";
  const shown = lab.flicks.value.slice(0, count);
  return shown.length === 0
    ? "This set-up cannot be flicked."
    : inWords(tallyOf(shown), shown.length);
}

/** The tally of a number of flicks in a sentence. */
function inWords({ outcome, left, right, others }: Tally, made: number): string {
  const did = outcome === "toppled" ? "fell" : "came up";
  const of = (side: Side, name: string) => {
    if (side.count === 0) return `none ${did} to the ${name}`;
    const spread = side.count > 1 ? ` ± ${side.deviation.toFixed(1)}°` : "";
    return `${side.count} ${did} to the ${name} after ${side.mean.toFixed(1)}°${spread}`;
  };
  const rest = others > 0 ? `; ${others} did something else` : "";
  return `Of ${made} flick${made === 1 ? "" : "s"}, ${of(left, "left")}, ${of(right, "right")}${rest}.`;
}
