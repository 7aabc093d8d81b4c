// Loads the part of the page that shakes the floor when the visitor first needs it.

import { effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { words } from "../words/words";

let loading: Promise<typeof import("./floor")> | undefined;

/** The part of the page that shakes the floor. */
export const loadFloor = (): Promise<typeof import("./floor")> => (loading ??= import("./floor"));

/** Loads it when a set-up has a floor that moves. */
export function shakeOnDemand(lab: Lab): void {
  effect(() => {
    const setups = [lab.setup.value, lab.otherSetup.value];
    if (setups.every((setup) => (setup?.floor ?? "rest") === "rest") || lab.shaker.peek()) return;
    loadFloor()
      .then(({ loadShaker }) => loadShaker())
      .then(
        (shaker) => (lab.shaker.value = shaker),
        (error: unknown) => {
          console.error(error);
          lab.shakerMissing.value = words.floor.isMissing;
        },
      );
  });
}
