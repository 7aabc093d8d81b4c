// The words of the page in the visitor's language, from a table of messages: en.json, de.json and so on. Modules can use
// them at any time, because they wait for this one.

import format, { type FormatValues } from "icu-minify/format";
import en from "./en.json";
import { LANGUAGE, type Language } from "./language";
import { TABLES, type Words } from "./tables";

const table = LANGUAGE === "en" ? undefined : await tableOf(LANGUAGE);

export const words: Words = table ?? en;

/** The texts of index.html; undefined in English, which the file itself has. */
export const prose: Words["prose"] | undefined = table?.prose;

/** The page is in English if the table of another language cannot be loaded. */
async function tableOf(language: Exclude<Language, "en">): Promise<Words | undefined> {
  try {
    return await TABLES[language]();
  } catch (error) {
    console.error(error);
    document.documentElement.lang = "en";
    return undefined;
  }
}

const FORMATTERS = {
  getDateTimeFormat: (...asked: ConstructorParameters<typeof Intl.DateTimeFormat>) =>
    new Intl.DateTimeFormat(...asked),
  getNumberFormat: (...asked: ConstructorParameters<typeof Intl.NumberFormat>) =>
    new Intl.NumberFormat(...asked),
  getPluralRules: (...asked: ConstructorParameters<typeof Intl.PluralRules>) =>
    new Intl.PluralRules(...asked),
};

/** A message of a language with values in its places. The build has parsed it: see web/messages.ts. */
export const sayIn = (language: Language, message: string, values: FormatValues): string =>
  String(format(message, language, values, { formatters: FORMATTERS }));

/** A message with values in its places. Numbers among them choose plurals; all others are texts with their units. */
export const say = (message: string, values: FormatValues): string =>
  sayIn(table ? LANGUAGE : "en", message, values);

/** Several names, of which the visitor chooses one, as values of a message. */
export const choiceOf = (names: readonly string[]): { names: string; last: string } => ({
  names: names.slice(0, -1).join(words.refusals.separator),
  last: names.at(-1) ?? "",
});

/** Joins sentences, leaving out empty ones. */
export const sentences = (...parts: readonly string[]): string =>
  parts.filter((part) => part !== "").join(words.between);
