// Synchronises the address with the set-up.

import { batch, effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { fromHash, holdsSetup, toHash } from "./url";

/** Reads the set-up from the address, now and whenever the visitor edits it, and writes changes back. A page
 * that rimroll.lab makes has the set-up in its first element. */
export function keepInAddress(lab: Lab): void {
  const read = (link: string) => {
    if (!holdsSetup(link)) return;
    const { setup, playback, refusals } = fromHash(link);
    batch(() => {
      lab.refusals.value = refusals;
      lab.change(setup);
      lab.setPlayback(playback);
    });
  };
  read(location.hash || `#${document.documentElement.dataset["setup"] ?? ""}`);
  // Read the address of the event: a later one may have been written since.
  addEventListener("hashchange", ({ newURL }) => read(new URL(newURL).hash));
  let timer: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const hash = toHash(lab.setup.value, lab.playback);
    clearTimeout(timer);
    timer = setTimeout(() => write(hash), WRITE_DELAY);
  });
}

/** The set-up is written after this time without a change, ms: browsers refuse a hundred changes of the
 * address within a few seconds, and a slider makes more. */
const WRITE_DELAY = 200;

function write(hash: string): void {
  // A page that another one holds as a text has no address of its own.
  if (location.protocol === "about:") return;
  // Replace the address, so that moves of a slider make no entries in the history.
  if (hash !== location.hash.replace(/^#/, ""))
    history.replaceState(null, "", hash === "" ? location.pathname + location.search : `#${hash}`);
}
