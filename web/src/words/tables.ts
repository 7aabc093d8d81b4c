// The tables of the other languages, each loaded for the visitors who read it. The page that rimroll.lab makes
// has tables_alone.ts in place of this file.

import type { Language } from "./language";
import type { Words } from "./words";

export const TABLES: Partial<Record<Language, () => Promise<Words>>> = {};
