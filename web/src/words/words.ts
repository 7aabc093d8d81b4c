// The words of the page in the visitor's language. Modules can use them at any time, because they wait for this
// one. A table therefore imports types only: a module of the page in it would wait for the table.

import { en } from "./en";
import { LANGUAGE, type Language } from "./language";
import type { Prose } from "./prose";
import { TABLES } from "./tables";

/** All words that the page's scripts say, in one language. */
export type Words = typeof en;

/** The table of another language, with the texts that index.html has in English. */
export type Table = Words & { prose: Prose };

const table = LANGUAGE === "en" ? undefined : await tableOf(LANGUAGE);

export const words: Words = table ?? en;

/** The texts of index.html; undefined in English. */
export const prose: Prose | undefined = table?.prose;

/** The page is in English if the table of another language cannot be loaded. */
async function tableOf(language: Exclude<Language, "en">): Promise<Table | undefined> {
  try {
    return await TABLES[language]();
  } catch (error) {
    console.error(error);
    document.documentElement.lang = "en";
    return undefined;
  }
}

/** Joins sentences, leaving out empty ones. */
export const sentences = (...parts: readonly string[]): string =>
  parts.filter((part) => part !== "").join(words.between);
