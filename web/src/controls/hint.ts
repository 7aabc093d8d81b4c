// What the quantity means that is pointed at or has the focus, in a place of its own: a line under
// each would not leave room for the table. Screen readers have it as the quantity's description.

import { element } from "../elements";

export function hintFor(place: HTMLElement): HTMLElement {
  const hint = element("p", { class: "hint", "aria-hidden": "true" });
  const helpOf = (target: EventTarget | null) =>
    (target as Element | null)?.closest<HTMLElement>("[data-help]")?.dataset["help"];
  const say = (event: Event) => {
    const focused = place.contains(document.activeElement) ? document.activeElement : null;
    hint.textContent = helpOf(event.target) ?? helpOf(focused) ?? hint.textContent;
  };
  for (const kind of ["pointerover", "focusin", "input"]) place.addEventListener(kind, say);
  hint.textContent = "Point at a setting to see what it means.";
  return hint;
}
