// Links to the page in each language, at its foot.

import { element } from "../elements";
import { LANGUAGE, LANGUAGES, type Language } from "./language";

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
