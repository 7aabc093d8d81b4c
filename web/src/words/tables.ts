// The tables of the other languages, each loaded for the visitors who read it. The page that rimroll.lab makes
// has tables_alone.ts in place of this file.

import type { Language } from "./language";
import type { Table } from "./words";

export const TABLES: Record<Exclude<Language, "en">, () => Promise<Table>> = {
  de: () => import("./de").then(({ de }) => de),
  es: () => import("./es").then(({ es }) => es),
  fr: () => import("./fr").then(({ fr }) => fr),
  pt: () => import("./pt").then(({ pt }) => pt),
  zh: () => import("./zh").then(({ zh }) => zh),
};
