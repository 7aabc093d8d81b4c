// Puts the words for a page whose script does not load into index.html.

import type { Plugin } from "vite";
import { UNLOADED } from "./src/words/unloaded";

/** What stands for the words in index.html. */
const PLACE = "WORDS_OF_UNLOADED_TS";

export function unloaded(): Plugin {
  const words = JSON.stringify(UNLOADED).replaceAll("<", "\\u003c");
  return {
    name: "unloaded",
    transformIndexHtml: {
      order: "pre",
      handler(page) {
        if (!page.includes(PLACE)) throw new Error(`index.html has no ${PLACE}`);
        return page.replace(PLACE, () => words);
      },
    },
  };
}
