// The flicks happen one after the other, so that one sees the histogram grow.

import type { Lab } from "../lab";

const A_FLICK = 140; // ms from one fall to the next, of forty-two

/** Lets the falls happen one after the other; all at once for who wants no motion. */
export function makeThem(lab: Lab): void {
  lab.flicksMade.value = 0;
  const all = lab.flicks.value.length;
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
    lab.flicksMade.value = all;
    return;
  }
  const begun = performance.now();
  const quicker = Math.max(1, all / 42);
  const go = () => {
    const made = lab.flicksMade.value;
    if (made === undefined || making !== go) return;
    const due = Math.min(all, Math.floor((quicker * (performance.now() - begun)) / A_FLICK));
    if (due > made) lab.flicksMade.value = due;
    if (due < all) setTimeout(go, A_FLICK / 2);
  };
  making = go;
  go();
}

/** Whoever makes the falls just now; a later call takes over. */
let making: (() => void) | undefined;
