// The tables of the other languages, each loaded for the visitors who read it. The page that rimroll.lab makes
// has tables_alone.ts in place of this file.

import type en from "./en.json";
import type { Language } from "./language";

/** All words that the page says, in one language. Messages with places for values are said by `say`. */
export type Words = Omit<typeof en, "nouns"> & {
  /** Forms of the noun of each body, as its sentences need them: the language's own, by their names. */
  nouns: Readonly<Record<keyof (typeof en)["nouns"], Readonly<Record<string, string>>>>;
};

export const TABLES: Record<Exclude<Language, "en">, () => Promise<Words>> = {
  de: () => import("./de.json").then((de) => de.default),
  es: () => import("./es.json").then((es) => es.default),
  fr: () => import("./fr.json").then((fr) => fr.default),
  pt: () => import("./pt.json").then((pt) => pt.default),
  zh: () => import("./zh.json").then((zh) => zh.default),
};
