// The group of controls of the floor. It is closed at first, and what is in it is loaded when it opens.

import { effect } from "@preact/signals-core";
import { element } from "../elements";
import { loadFloor } from "../floor/loading";
import type { SetupForm } from "../inputs/setup_form";
import { FIELDS, FLOOR_FIELDS } from "../setup/fields";
import { say, words } from "../words/words";

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
