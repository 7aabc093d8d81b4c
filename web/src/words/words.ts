// The words of the page in the visitor's language. Modules can use them at any time, because they wait for this
// one. A table therefore imports types only: a module of the page in it would wait for the table.

import { en } from "./en";
import { LANGUAGE, type Language } from "./language";
import { TABLES } from "./tables";

/** All words that the page says, in one language. */
export type Words = typeof en;

export const words: Words = LANGUAGE === "en" ? en : await wordsIn(LANGUAGE);

/** English if the table of another language cannot be loaded. */
async function wordsIn(language: Language): Promise<Words> {
  try {
    return (await TABLES[language]?.()) ?? en;
  } catch (error) {
    console.error(error);
    document.documentElement.lang = "en";
    return en;
  }
}

/** Joins sentences, leaving out empty ones. */
export const sentences = (...parts: readonly string[]): string =>
  parts.filter((part) => part !== "").join(words.between);
