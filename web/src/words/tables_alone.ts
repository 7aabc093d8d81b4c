// All tables, for the page in one script. A table that is imported only when it is asked for would stand behind
// the modules that wait for it.

import { de } from "./de";
import { es } from "./es";
import { fr } from "./fr";
import type { TABLES as LOADED } from "./tables";
import { pt } from "./pt";
import { zh } from "./zh";

export const TABLES: typeof LOADED = {
  de: async () => de,
  es: async () => es,
  fr: async () => fr,
  pt: async () => pt,
  zh: async () => zh,
};
