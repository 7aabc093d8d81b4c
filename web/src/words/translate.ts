// Writes the texts of index.html in the visitor's language, and shows the page, which index.html hides until then.

import { words, prose } from "./words";
import type { Prose } from "./prose";

export function translatePage(): void {
  if (prose) {
    for (const place of document.querySelectorAll<HTMLElement>("[data-words]"))
      place.replaceChildren(...filled(prose[place.dataset["words"] as keyof Prose], place));
    for (const place of document.querySelectorAll<HTMLElement>("[data-label]"))
      place.setAttribute("aria-label", prose[place.dataset["label"] as keyof Prose]);
    for (const place of document.querySelectorAll(".loading")) place.textContent = words.loading;
  }
  document.documentElement.removeAttribute("data-translating");
}

/** A text with the elements of a place where it has `{0}`, `{1}` and so on. */
function filled(text: string, { children }: Element): (string | Element)[] {
  const elements = [...children];
  return text.split(/\{(\d)\}/).map((part, k) => (k % 2 ? elements[Number(part)]! : part));
}
