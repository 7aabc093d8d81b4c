// The flicks happen one after the other, so that one sees the histogram grow.

import { batch } from "@preact/signals-core";
import type { Lab } from "../lab";
import { prefersReducedMotion } from "../reduced_motion";

const A_FLICK = 140; // ms from one fall to the next, of forty-two

/** Lets the falls happen one after the other; all at once for who wants no motion. */
export function startFlicks(lab: Lab): void {
  making = undefined;
  batch(() => {
    show(lab, 0, true);
    // Of a set-up that is refused there is nothing to watch; once it is mended, they are there.
    if (prefersReducedMotion() || lab.flicks.value.length === 0)
      show(lab, lab.setup.value.flicks, false);
  });
  if (!lab.flicking.value) return;
  const begun = performance.now();
  const go = () => {
    if (making !== go || !lab.flicking.value) return;
    // It may be changed on the way.
    const all = lab.setup.value.flicks;
    const quicker = Math.max(1, all / 42);
    const due = Math.min(all, Math.floor((quicker * (performance.now() - begun)) / A_FLICK));
    show(lab, due, due < all);
    if (due < all) setTimeout(go, A_FLICK / 2);
  };
  making = go;
  go();
}

/** Takes them away. */
export function clearFlicks(lab: Lab): void {
  making = undefined;
  show(lab, undefined, false);
}

/** Whoever makes the falls just now; a later call takes over. */
let making: (() => void) | undefined;

function show(lab: Lab, made: number | undefined, making: boolean): void {
  batch(() => {
    lab.flicksShown.value = made;
    lab.flicking.value = making;
  });
}
