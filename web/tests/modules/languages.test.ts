// The tables of all languages say the same: every word, every number, and a sentence for every case.

import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import compile from "icu-minify/compile";
import ts from "typescript";
import { expect, test } from "vitest";
import { withProse } from "../../messages";
import { FIELDS } from "../../src/setup/fields";
import { type Language, LANGUAGES } from "../../src/words/language";
import { said, TABLES } from "../given/tables";

const PAGE = readFileSync(new URL("../../index.html", import.meta.url), "utf8");
const OTHERS = LANGUAGES.filter((language) => language !== "en");
const { en } = TABLES;

/** Texts that are no messages: `{0}` in them stands for an element or a reason. */
const APART = /^(prose|unloaded|nouns)\./;

/** The texts of a table by their paths. */
function textsOf(table: object, path = ""): [string, string][] {
  return Object.entries(table).flatMap(([key, value]): [string, string][] =>
    typeof value === "object" ? textsOf(value, `${path}${key}.`) : [[path + key, value]],
  );
}

const TEXTS = Object.fromEntries(
  LANGUAGES.map((language) => [language, new Map(textsOf(TABLES[language]))]),
) as unknown as Record<Language, ReadonlyMap<string, string>>;

const MESSAGES = new Map(textsOf(en).filter(([path]) => !APART.test(path)));

/** The numbers in a text, in any order, because languages order a sentence differently. */
const numbersIn = (text: string) =>
  [...text.matchAll(/\d+(?:[.,]\d+)?/g)].map(([one]) => one.replace(",", ".")).sort();

/** What a message needs: the cases of each value that it chooses by, and no cases for a value that it shows. */
type Needs = Map<string, Need>;

interface Need {
  kind: "shown" | "select" | "plural";
  cases: Set<string>;
}

const [SELECT, PLURAL] = [1, 2];

function needsOf(message: string): Needs {
  const needs: Needs = new Map();
  const collect = (nodes: unknown): void => {
    for (const node of Array.isArray(nodes) ? nodes : []) {
      if (!Array.isArray(node)) continue;
      const [name, type, options] = node as [string, number?, Record<string, unknown>?];
      const kind = type === SELECT ? "select" : type === PLURAL ? "plural" : "shown";
      const known = needs.get(name);
      const need: Need = known && known.kind !== "shown" ? known : { kind, cases: new Set() };
      needs.set(name, need);
      for (const [key, inside] of Object.entries(options ?? {})) {
        need.cases.add(key);
        collect(inside);
      }
    }
  };
  collect(compile(message));
  return needs;
}

const BODIES = Object.keys(FIELDS.body.choices) as (keyof typeof en.nouns)[];

test("each language has every word of English, and no other", () => {
  const pathsOf = ({ nouns: _, ...table }: object & { nouns: object }) =>
    textsOf(table).map(([path]) => path);
  for (const language of OTHERS)
    expect(pathsOf(TABLES[language]).sort(), language).toEqual(pathsOf(en).sort());
});

test("each language has the same forms of the nouns of all bodies", () => {
  for (const language of LANGUAGES) {
    const { nouns } = TABLES[language];
    expect(Object.keys(nouns), language).toEqual(BODIES);
    for (const forms of Object.values(nouns))
      expect(Object.keys(forms), language).toEqual(Object.keys(nouns.own));
  }
});

test("the numbers in a text are those of English", () => {
  for (const language of OTHERS)
    for (const [path, text] of TEXTS[language]) {
      const source = TEXTS.en.get(path);
      if (source === undefined || (MESSAGES.has(path) && needsOf(source).size > 0)) continue;
      if (/^scene\.keys\.\d\.key$/.test(path)) continue; // names of keys, as the German Pos1
      expect(numbersIn(text), `${language}.${path}`).toEqual(numbersIn(source));
      expect(text.trim() === "", `${language}.${path}`).toBe(source.trim() === "");
    }
});

/** Marks in French with an ordinary space beside them, at which a line could break. */
const BREAKABLE = / [:;!?»]|« /;

const placesIn = (text: string) => [...text.matchAll(/⟨\w+⟩/g)].map(([one]) => one).sort();

/** All values with which an English message is said, without the forms of a noun. */
const valuesFor = (needs: Needs): Record<string, string | number>[] =>
  [...needs]
    .filter(([name]) => name !== "noun")
    .reduce<Record<string, string | number>[]>(
      (all, [name, { kind, cases }]) => {
        const choices =
          kind === "plural" ? [0, 1, 2, 42] : kind === "select" ? [...cases] : [`⟨${name}⟩`];
        return all.flatMap((values) => choices.map((choice) => ({ ...values, [name]: choice })));
      },
      [{}],
    );

test("each message makes a sentence in each case, with all that it is given", () => {
  for (const [path, english] of MESSAGES) {
    const needs = needsOf(english);
    for (const language of LANGUAGES) {
      const table = TABLES[language];
      const message = TEXTS[language].get(path) ?? "";
      for (const values of valuesFor(needs))
        for (const body of needs.has("noun") ? BODIES : (["own"] as const)) {
          const source = said("en", english, { ...values, ...en.nouns[body] });
          const forms = needs.has("noun") ? table.nouns[body] : {};
          const text = said(language, message, { ...values, ...forms });
          const what = `${language}.${path}(${JSON.stringify(values)}): ${text}`;
          expect(text, what).not.toMatch(/undefined|\[object|NaN|[{}]/);
          if (language === "fr") expect(text, what).not.toMatch(BREAKABLE);
          expect(placesIn(text.toUpperCase()), what).toEqual(placesIn(source.toUpperCase()));
        }
    }
  }
});

test("messages choose by the cases of English, and by the plurals of their language", () => {
  for (const [path, english] of MESSAGES)
    for (const language of LANGUAGES) {
      const message = TEXTS[language].get(path) ?? "";
      const { pluralCategories } = new Intl.PluralRules(language).resolvedOptions();
      for (const [name, { kind, cases }] of needsOf(message)) {
        const what = `${language}.${path}: ${name}`;
        if (kind === "select")
          expect([...cases], what).toEqual([...needsOf(english).get(name)!.cases]);
        if (kind === "plural")
          for (const each of cases)
            if (!/^=\d$/.test(each)) expect(pluralCategories, what).toContain(each);
      }
    }
});

test("the flicks are counted on both sides, on one, and on none", () => {
  for (const language of LANGUAGES)
    for (const made of [1, 2, 42])
      for (const fell of ["true", "false"])
        for (const others of [0, 1, 3]) {
          const { side: message, summary } = TABLES[language].flicks;
          const [left, right] = ["left", "right"].map((side, k) =>
            said(language, message, { side, fell, count: k === 0 ? 20 : 0, angle: "⟨a⟩" }),
          ) as [string, string];
          const text = said(language, summary, { made, left, right, others });
          for (const part of [String(made), "20", "⟨a⟩"]) expect(text, language).toContain(part);
          expect(right, language).not.toMatch(/⟨a⟩|\d/);
          if (others > 1) expect(text, language).toContain(String(others));
        }
});

test("French marks of punctuation stay with their words", () => {
  for (const [path, text] of TEXTS.fr) expect(text, path).not.toMatch(BREAKABLE);
});

const SOURCES = fileURLToPath(new URL("../../src", import.meta.url));

/** What the scripts of the page say: each use of `words`, with the values if it is said as a message. A spread of the
 * forms of a noun is the value `noun`. */
function* usesOfWords(): Generator<{ file: string; path: string; values?: string[] }> {
  for (const file of readdirSync(SOURCES, { recursive: true }).map(String)) {
    if (!file.endsWith(".ts") || file.startsWith("words")) continue;
    const text = readFileSync(`${SOURCES}/${file}`, "utf8");
    const source = ts.createSourceFile(file, text, ts.ScriptTarget.Latest, true);
    const names = new Map([["words", ""]]);
    const pathOf = (node: ts.Node): string | undefined => {
      if (ts.isIdentifier(node)) return names.get(node.text);
      if (!ts.isPropertyAccessExpression(node)) return undefined;
      const base = pathOf(node.expression);
      return base === undefined ? undefined : `${base}${base && "."}${node.name.text}`;
    };
    /** Names that a file gives to parts of the table, as in `const { verdict } = words`. */
    const name = (node: ts.Node): void => {
      const base = ts.isVariableDeclaration(node) && node.initializer && pathOf(node.initializer);
      if (ts.isVariableDeclaration(node) && base !== undefined && base !== false) {
        if (ts.isIdentifier(node.name)) names.set(node.name.text, base as string);
        else
          for (const part of node.name.elements)
            if (ts.isBindingElement(part) && ts.isIdentifier(part.name)) {
              const key = part.propertyName?.getText() ?? part.name.text;
              names.set(part.name.text, `${base}${base && "."}${key}`);
            }
      }
      ts.forEachChild(node, name);
    };
    name(source);
    const uses: { file: string; path: string; values?: string[] }[] = [];
    const visit = (node: ts.Node): void => {
      if (ts.isCallExpression(node) && node.expression.getText() === "say") {
        const [message, values] = node.arguments;
        const path = message && pathOf(message);
        if (path !== undefined && values && ts.isObjectLiteralExpression(values)) {
          const given = values.properties.flatMap((property) => {
            if (!ts.isSpreadAssignment(property)) return [property.name!.getText()];
            if (/words\.nouns\b/.test(property.getText())) return ["noun"];
            return /choiceOf\(/.test(property.getText()) ? ["names", "last"] : ["left", "right"];
          });
          uses.push({ file, path, values: given });
          return ts.forEachChild(values, visit);
        }
      }
      const path = ts.isPropertyAccessExpression(node) ? pathOf(node) : undefined;
      if (path !== undefined) uses.push({ file, path });
      else ts.forEachChild(node, visit);
    };
    visit(source);
    yield* uses;
  }
}

test("the page says each message with the values that it needs", () => {
  let messages = 0;
  for (const { file, path, values } of usesOfWords()) {
    const message = MESSAGES.get(path);
    if (message === undefined) continue; // a part of the table
    const needs = [...needsOf(message).keys()].sort();
    expect([...(values ?? [])].sort(), `${file} says ${path}`).toEqual(needs);
    if (values) messages++;
  }
  expect(messages).toBeGreaterThan(100);
});

/** The places of index.html with texts, and how many elements each has inside. */
function placesOfPage(): Map<string, number> {
  const places = new Map<string, number>();
  for (const [, tag, name] of PAGE.matchAll(/<(\w+)\b[^>]*\bdata-words="([^"]+)"/g)) {
    const from = PAGE.indexOf(`data-words="${name}"`);
    const inside = PAGE.slice(PAGE.indexOf(">", from) + 1, PAGE.indexOf(`</${tag}`, from));
    // Elements inside, but not those of a formula.
    const outer = inside.replace(/<math[\s\S]*?<\/math\s*>/g, "<b></b>");
    places.set(name!, outer.match(/<(?:b|i|a)\b/g)?.length ?? 0);
  }
  for (const [, name] of PAGE.matchAll(/data-label="([^"]+)"/g))
    if (!places.has(name!)) places.set(name!, 0);
  return places;
}

test("each text of index.html is in each language, with its numbers, formulas and links", () => {
  const places = placesOfPage();
  expect(places.get("hand.symbols")).toBe(4);
  expect(places.get("disks-and-coins.text")).toBe(3);
  for (const language of LANGUAGES) {
    const { prose } = TABLES[language];
    expect(Object.keys(prose).sort(), language).toEqual([...places.keys()].sort());
    for (const [name, text] of Object.entries(prose)) {
      const used = [...text.matchAll(/\{(\d)\}/g)].map(([, k]) => Number(k)).sort();
      const all = Array.from({ length: places.get(name)! }, (_, k) => k);
      expect(used, `${language}.${name}`).toEqual(all);
      expect(text.trim(), `${language}.${name}`).not.toBe("");
    }
  }
});

test("the built index.html has the English texts, around what is inside", () => {
  const page = withProse(PAGE, en.prose).replace(/\s+/g, " ");
  expect(page).toContain(">Here <i>m</i> is its mass, <i>R</i> the radius of its base, <i>H</i>");
  expect(page).toContain("gives <math ><mi>π</mi>");
  expect(page).toMatch(/<p data-words="foot.parts"><a [^>]*>Licences<\/a> of this page/);
  expect(page).toContain('data-label="section.verdict" aria-label="What happens"');
  expect(page).not.toMatch(/data-words="[^"]+"[^>]*><\//);
});

test("index.html chooses among the languages that there are", () => {
  const [, choices] = /\/\^\(([a-z|]+)\)\\b\//.exec(PAGE)!;
  expect(choices!.split("|")).toEqual([...LANGUAGES]);
});

test("what the page says when it cannot load has the same commands in all languages", () => {
  // Commands, addresses and what stands for others.
  const fixed = (text: string) => [...text.matchAll(/`[^`]*`|\{\d\}|\d{4}/g)].map(([it]) => it);
  for (const language of OTHERS as Language[])
    for (const [name, text] of Object.entries(TABLES[language].unloaded)) {
      const english = en.unloaded[name as keyof typeof en.unloaded];
      expect(fixed(text).sort(), text).toEqual(fixed(english).sort());
      expect(text).not.toBe(english);
    }
});
