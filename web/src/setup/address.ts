// Keeps the address and the set-up the same.

import { batch, effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { fromHash, holdsSetup, toHash } from "./url";

/** Takes the set-up from the address, now and whenever the visitor changes it, and writes it there. */
export function keepInAddress(lab: Lab): void {
  const take = (link: string) => {
    if (!holdsSetup(link)) return;
    const { setup, playback, refusals } = fromHash(link);
    batch(() => {
      lab.refusals.value = refusals;
      lab.change(setup);
      lab.clock.setPlayback(playback);
    });
  };
  take(location.hash);
  // The address that the visitor gave, though another may have been written since.
  addEventListener("hashchange", ({ newURL }) => take(new URL(newURL).hash));
  let waiting: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const hash = toHash(lab.setup.value, lab.clock.playback);
    clearTimeout(waiting);
    waiting = setTimeout(() => write(hash), QUIET);
  });
}

/** How long the set-up stays as it is before it is written, ms: browsers refuse a hundred addresses
 * in a few seconds, and a slider makes more. */
const QUIET = 200;

function write(hash: string): void {
  // Without an entry in the history for every move of a slider.
  if (hash !== location.hash.replace(/^#/, ""))
    history.replaceState(null, "", hash === "" ? location.pathname + location.search : `#${hash}`);
}
