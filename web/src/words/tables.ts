// The tables of the other languages, each loaded for the visitors who read it. The page that rimroll.lab makes
// has tables_alone.ts in place of this file.

import type { Language } from "./language";
import type { Words } from "./words";

export const TABLES: Record<Exclude<Language, "en">, () => Promise<Words>> = {
  de: () => import("./de.json").then((de) => de.default),
  es: () => import("./es.json").then((es) => es.default),
  fr: () => import("./fr.json").then((fr) => fr.default),
  pt: () => import("./pt.json").then((pt) => pt.default),
  zh: () => import("./zh.json").then((zh) => zh.default),
};
