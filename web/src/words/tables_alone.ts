// All tables, for the page in one script. A table that is imported only when it is asked for would stand behind
// the modules that wait for it.

import de from "./de.json";
import es from "./es.json";
import fr from "./fr.json";
import type { TABLES as LOADED } from "./tables";
import pt from "./pt.json";
import zh from "./zh.json";

export const TABLES: typeof LOADED = {
  de: async () => de,
  es: async () => es,
  fr: async () => fr,
  pt: async () => pt,
  zh: async () => zh,
};
