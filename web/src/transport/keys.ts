// Keys that work anywhere on the page but where somebody types or a control has its own use for them.

import { type Signal, signal } from "@preact/signals-core";

/** Whether the keys work; one who talks to a computer may not want them to. */
export const keysOn: Signal<boolean> = signal(true);

/** Which elements use a key themselves. */
const TYPED_IN =
  "input:not([type=range], [type=checkbox], [type=radio], [type=button]), select, textarea, [contenteditable], [role=textbox]";
const PRESSED = "button, summary, a[href], input, select, [role=button], [role=slider]";

export function onKeys(actions: Record<string, () => void>): void {
  addEventListener("keydown", (event) => {
    const act = actions[event.key];
    if (!act || !keysOn.value || event.defaultPrevented) return;
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const target = event.target instanceof Element ? event.target : document.body;
    const punctuation = event.key === "," || event.key === ".";
    if (target.closest(punctuation ? TYPED_IN : `${TYPED_IN}, ${PRESSED}`)) return;
    act();
    // The page scrolls to its top as well on Home: the scene is there.
    if (event.key !== "Home") event.preventDefault();
  });
}
