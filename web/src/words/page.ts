// The words of index.html in the visitor's language, and the links to the other languages.

import { prose, words } from "./words";
import { element } from "../elements";
import { LANGUAGE, type Language, LANGUAGES } from "./language";

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

// Links to the page in each language, at its foot.

/** Each language in its own words, as visitors look for theirs. */
const NAMES: Record<Language, string> = {
  en: "English",
  de: "Deutsch",
  es: "Español",
  fr: "Français",
  pt: "Português",
  zh: "中文",
};

export function mountLanguages(place: HTMLElement): void {
  // In a notebook, whose frame has no address, the link would lead to another page.
  if (!/^(https?|file):$/.test(location.protocol)) return;
  for (const lang of LANGUAGES) {
    const link = element("a", { lang, hreflang: lang, href: `?lang=${lang}` }, NAMES[lang]);
    if (lang === LANGUAGE) link.setAttribute("aria-current", "true");
    // The # part of the address, which changes with the set-up, stays as it is.
    link.addEventListener("click", () => (link.href = `?lang=${lang}${location.hash}`));
    place.append(link);
  }
}
