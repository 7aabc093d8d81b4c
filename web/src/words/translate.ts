// Writes the texts of index.html in the visitor's language, and shows the page, which index.html hides until then.

import { words, prose } from "./words";

export function translatePage(): void {
  if (prose) {
    const textOf = (name = "") => prose?.[name as keyof typeof prose] ?? "";
    for (const place of document.querySelectorAll<HTMLElement>("[data-words]"))
      place.replaceChildren(...filled(textOf(place.dataset["words"]), place));
    for (const place of document.querySelectorAll<HTMLElement>("[data-label]"))
      place.setAttribute("aria-label", textOf(place.dataset["label"]));
    for (const place of document.querySelectorAll(".loading")) place.textContent = words.loading;
  }
  document.documentElement.removeAttribute("data-translating");
}

/** A text with the elements of a place where it has `{0}`, `{1}` and so on. */
function filled(text: string, { children }: Element): (string | Element)[] {
  const elements = [...children];
  return text.split(/\{(\d)\}/).map((part, k) => (k % 2 ? elements[Number(part)]! : part));
}
