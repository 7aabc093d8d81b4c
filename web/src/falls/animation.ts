// Shows the flicks one after the other, so that the histogram grows.

import { batch } from "@preact/signals-core";
import type { Lab } from "../lab";
import { prefersReducedMotion } from "../reduced_motion";

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
