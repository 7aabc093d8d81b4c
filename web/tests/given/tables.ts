// The tables of words as translators write them, before the build parses their messages.

import { readFileSync } from "node:fs";
import compile from "icu-minify/compile";
import { LANGUAGES, type Language } from "../../src/words/language";
import type { Words } from "../../src/words/tables";
import { sayIn } from "../../src/words/words";

const read = (language: Language): Words =>
  JSON.parse(
    readFileSync(new URL(`../../src/words/${language}.json`, import.meta.url), "utf8"),
  ) as Words;

export const TABLES = Object.fromEntries(
  LANGUAGES.map((language) => [language, read(language)]),
) as Record<Language, Words>;

/** A message of a table in a language, with values in its places. */
export const said = (
  language: Language,
  message: string,
  values: Record<string, string | number>,
) => sayIn(language, compile(message) as string, values);
