// The button that turns the sound on and off. It is off at first; what makes the sound is loaded when it is first turned on.

import { effect, signal } from "@preact/signals-core";
import { element, icon } from "../elements";
import type { Lab } from "../lab";
import { words } from "../words/words";

/** Whether the sound is on, in the whole page. */
const on = signal(false);
/** Why there is none. */
const missing = signal(false);

/** The button; the motion of a lab sounds while `active` is true. */
export function soundButton(lab: Lab, active: () => boolean = () => true): HTMLButtonElement {
  const { sound } = words;
  const made = element("button", { type: "button", class: "sound", "aria-label": sound.name });
  made.addEventListener("click", () => (on.value = !on.value && !missing.value));
  effect(() => {
    made.replaceChildren(icon(on.value ? "sound" : "silence"));
    made.setAttribute("aria-pressed", String(on.value));
    made.title = missing.value ? sound.missing : on.value ? sound.turnOff : sound.turnOn;
  });
  effect(() => {
    if (!on.value || !active()) return undefined;
    let speaker: { close(): void } | undefined;
    let closed = false;
    import("./speaker")
      .then(({ Speaker }) => {
        if (!closed) speaker = new Speaker(lab);
      })
      .catch((error: unknown) => {
        console.warn(error);
        missing.value = true;
        on.value = false;
      });
    return () => {
      closed = true;
      speaker?.close();
    };
  });
  return made;
}
