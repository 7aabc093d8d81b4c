// Keys that work anywhere in the lab, except in text fields and in controls that use them.

import { type Signal, signal } from "@preact/signals-core";
import { shownPart } from "../part";

/** Whether the keys work; visitors who use speech input can switch them off. */
export const keysOn: Signal<boolean> = signal(true);

/** Elements that use keys themselves. */
const TYPED_IN =
  "input:not([type=range], [type=checkbox], [type=radio], [type=button]), select, textarea, [contenteditable], [role=textbox]";
const PRESSED = "button, summary, a[href], input, select, [role=button], [role=slider]";

export function onKeys(actions: Record<string, () => void>): void {
  addEventListener("keydown", (event) => {
    const act = actions[event.key];
    if (!act || !keysOn.value || event.defaultPrevented || shownPart() !== "lab") return;
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const target = event.target instanceof Element ? event.target : document.body;
    const punctuation = event.key === "," || event.key === ".";
    if (target.closest(punctuation ? TYPED_IN : `${TYPED_IN}, ${PRESSED}`)) return;
    act();
    // On Home the page also scrolls to its top, where the scene is.
    if (event.key !== "Home") event.preventDefault();
  });
}
