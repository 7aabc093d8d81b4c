// The flicks that the page shows: one after the other, so that the histogram grows, and summarised in a sentence.

import { batch } from "@preact/signals-core";
import type { Lab } from "../lab";
import { prefersReducedMotion } from "../timing";
import { type Side, type Tally, tallyOf } from "./tally";
import { formatFixed } from "../format";
import { say, words } from "../words/words";

const INTERVAL = 140; // ms between the falls, if there are 42

/** Shows the flicks one after the other, or all at once for a visitor who prefers reduced motion. */
export function startFlicks(lab: Lab): void {
  running = undefined;
  show(lab, 0, true);
  // A refused set-up has no flicks to animate; they appear once it is corrected.
  if (prefersReducedMotion() || lab.flicks.value.length === 0)
    show(lab, lab.setup.value.flicks, false);
  if (!lab.flicking.value) return;
  const begun = performance.now();
  const update = () => {
    if (running !== update || !lab.flicking.value) return;
    // The visitor may change the number meanwhile.
    const all = lab.setup.value.flicks;
    const speedup = Math.max(1, all / 42);
    const due = Math.min(all, Math.floor((speedup * (performance.now() - begun)) / INTERVAL));
    show(lab, due, due < all);
    if (due < all) setTimeout(update, INTERVAL / 2);
  };
  running = update;
  update();
}

/** Removes the flicks. */
export function clearFlicks(lab: Lab): void {
  running = undefined;
  show(lab, undefined, false);
}

/** The animation that runs at present; a later call replaces it. */
let running: (() => void) | undefined;

function show(lab: Lab, count: number | undefined, flicking: boolean): void {
  batch(() => {
    lab.flicksShown.value = count;
    lab.flicking.value = flicking;
  });
}

// Summarises the flicks in a sentence.

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
