// Summarises the flicks in a sentence.

import type { Lab } from "../lab";
import { type Side, type Tally, tallyOf } from "./tally";
import { formatFixed } from "../format/numbers";
import { say, words } from "../words/words";

/** A sentence on the flicks that are shown, or a notice while they are still appearing. */
export function flickSummary(lab: Lab): string {
  const count = lab.flicksShown.value;
  if (count === undefined) return "";
  const shown = lab.flicks.value.slice(0, count);
  const computing = shown.length < count && !lab.flicksComplete.value;
  if (lab.flicking.value || computing) return words.flicks.running;
  return shown.length === 0 ? words.flicks.none : inWords(tallyOf(shown), shown.length);
}

/** The tally of a number of flicks in a sentence. */
export function inWords({ outcome, left, right, others }: Tally, made: number): string {
  const fell = outcome === "toppled";
  const to = (side: "left" | "right", falls: Side) =>
    say(words.flicks.side, { side, fell, count: falls.count, angle: angleOf(falls) });
  const sides = { left: to("left", left), right: to("right", right) };
  return say(words.flicks.summary, { made, ...sides, others });
}

function angleOf({ count, mean, deviation }: Side): string {
  const spread = count > 1 ? ` ± ${formatFixed(deviation, 1)}°` : "";
  return `${formatFixed(mean, 1)}°${spread}`;
}
