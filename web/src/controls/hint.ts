// Shows the help text of the quantity under the pointer or with the focus in one place, because a line
// under each quantity would leave no room for the table. Screen readers read it as a description.

import { element } from "../elements";
import { words } from "../words/words";

export function hintFor(place: HTMLElement): HTMLElement {
  const hint = element("p", { class: "hint", "aria-hidden": "true" });
  const helpOf = (target: EventTarget | null) =>
    (target as Element | null)?.closest<HTMLElement>("[data-help]")?.dataset["help"];
  const say = (event: Event) => {
    const focused = place.contains(document.activeElement) ? document.activeElement : null;
    hint.textContent = helpOf(event.target) ?? helpOf(focused) ?? hint.textContent;
  };
  for (const kind of ["pointerover", "focusin", "input"]) place.addEventListener(kind, say);
  hint.textContent = words.controls.hint;
  return hint;
}
