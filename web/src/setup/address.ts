// Keeps the address and the set-up the same.

import { effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { fromHash, toHash } from "./url";

/** Takes the set-up from the address, now and whenever the visitor changes it, and writes it there. */
export function keepInAddress(lab: Lab): void {
  const take = () => {
    const { setup, refusals } = fromHash(location.hash);
    lab.refusals.value = refusals;
    lab.change(setup);
  };
  take();
  addEventListener("hashchange", take);
  effect(() => {
    const hash = toHash(lab.setup.value);
    // Without an entry in the history for every move of a slider.
    if (hash !== location.hash.replace(/^#/, ""))
      history.replaceState(
        null,
        "",
        hash === "" ? location.pathname + location.search : `#${hash}`,
      );
  });
}
