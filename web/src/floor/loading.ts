// Loads the part of the page that shakes the floor when the visitor first needs it.

import { effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { say, words } from "../words/words";
import { element } from "../elements";
import type { SetupForm } from "../controls/setup_form";
import { FIELDS, FLOOR_FIELDS } from "../setup/fields";

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

// The group of controls of the floor. It is closed at first, and what is in it is loaded when it opens.

export function floorGroup(form: SetupForm): HTMLElement {
  const summary = element("summary");
  const status = element("p", { class: "help", role: "status" });
  const details = element("details", { class: "more floor" }, summary, status);
  let mounted = false;
  details.addEventListener("toggle", () => {
    if (mounted || !details.open) return;
    mounted = true;
    status.textContent = words.loading;
    loadFloor().then(
      ({ mountFloorControls }) => {
        status.remove();
        mountFloorControls(form, details);
      },
      () => (status.textContent = words.controls.notLoaded),
    );
  });
  effect(() => {
    const { floor } = form.lab.setup.value;
    summary.textContent = say(words.controls.floor, { state: begun(FIELDS.floor.choices[floor]) });
    const inside: readonly string[] = FLOOR_FIELDS;
    if (floor !== "rest" || form.lab.refusals.value.some(({ field }) => inside.includes(field)))
      details.open = true;
  });
  return details;
}

/** A text that begins inside a sentence. */
const begun = (text: string) => text.charAt(0).toLowerCase() + text.slice(1);
