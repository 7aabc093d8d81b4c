// Puts the tables of words into the page. The build parses their messages, so that the page need not; index.html gets
// its English texts, and what it says in all languages when the page's script does not load.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import compile from "icu-minify/compile";
import type { Plugin } from "vite";
import { LANGUAGES } from "./src/words/language";
import type { Words } from "./src/words/tables";

const FOLDER = join(import.meta.dirname, "src/words");

const tableOf = (language: string): Words =>
  JSON.parse(readFileSync(join(FOLDER, `${language}.json`), "utf8"));

/** What stands for the words in index.html. */
const PLACE = "WORDS_OF_UNLOADED";

export function messages(): Plugin {
  return {
    name: "messages",
    enforce: "pre",
    transform(code, id) {
      const [, language] = /\/src\/words\/(\w+)\.json$/.exec(id) ?? [];
      if (language === undefined) return undefined;
      const { unloaded: _, prose, ...table } = JSON.parse(code) as Words;
      const parsed = parsedIn(table) as object;
      return JSON.stringify(language === "en" ? parsed : { ...parsed, prose });
    },
    transformIndexHtml: {
      order: "pre",
      handler(page) {
        if (!page.includes(PLACE)) throw new Error(`index.html has no ${PLACE}`);
        const unloaded = LANGUAGES.map((language) => [language, tableOf(language).unloaded]);
        const said = JSON.stringify(Object.fromEntries(unloaded)).replaceAll("<", "\\u003c");
        return withProse(page, tableOf("en").prose).replace(PLACE, () => said);
      },
    },
  };
}

const parsedIn = (table: unknown): unknown => {
  if (typeof table === "string") return compile(table);
  if (Array.isArray(table)) return table.map(parsedIn);
  return Object.fromEntries(
    Object.entries(table as object).map(([name, inside]) => [name, parsedIn(inside)]),
  );
};

/** An element with a text, by the name of the text, and the elements inside such an element. */
const TEXT = /(<(\w+)\b[^>]*\bdata-words="([^"]+)"[^>]*>)([\s\S]*?)(<\/\2\s*>)/g;
const ELEMENT = /<(\w+)\b[^>]*>[\s\S]*?<\/\1\s*>/g;

/** index.html with its texts and labels, which have the elements inside at their places `{0}`, `{1}` and so on. */
export function withProse(page: string, prose: Readonly<Record<string, string>>): string {
  const textOf = (name: string) => {
    const text = prose[name];
    if (text === undefined) throw new Error(`the English table has no text ${name}`);
    return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
  };
  const filled = (html: string): string =>
    html.replace(TEXT, (_all, open: string, _tag, name: string, inside: string, close: string) => {
      const elements = inside.match(ELEMENT) ?? [];
      const text = textOf(name).replace(/\{(\d)\}/g, (_, k) => filled(elements[Number(k)] ?? ""));
      return open + text + close;
    });
  return filled(page).replace(
    /data-label="([^"]+)"/g,
    (label, name: string) => `${label} aria-label="${textOf(name)}"`,
  );
}
