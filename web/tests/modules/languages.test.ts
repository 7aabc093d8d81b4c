// The tables of all languages say the same: every word, every number, and a sentence for every case.

import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import type { BodyName } from "../../src/setup/fields";
import { en } from "../../src/words/en";
import { LANGUAGES } from "../../src/words/language";
import { TABLES } from "../../src/words/tables";
import type { Table } from "../../src/words/words";

const PAGE = readFileSync(new URL("../../index.html", import.meta.url), "utf8");
const OTHERS = LANGUAGES.filter((language) => language !== "en");

const BODIES = Object.keys(en.fields.body.choices) as BodyName[];

type Leaf = string | ((...given: never[]) => string);

/** The texts and functions of a table by their paths, sorted. */
function leavesOf(table: object, path = ""): [string, Leaf][] {
  return Object.entries(table)
    .flatMap(([key, value]): [string, Leaf][] =>
      value !== null && typeof value === "object"
        ? leavesOf(value, `${path}.${key}`)
        : [[`${path}.${key}`, value as Leaf]],
    )
    .sort(([a], [b]) => (a < b ? -1 : 1));
}

/** The numbers in a text, in any order, because languages order a sentence differently. */
const numbersIn = (text: string) =>
  [...text.matchAll(/\d+(?:[.,]\d+)?/g)].map(([one]) => one.replace(",", ".")).sort();

const tables = async () =>
  Promise.all(OTHERS.map(async (language) => [language, await TABLES[language]()] as const));

test("each language has every word of English, and no other", async () => {
  for (const [language, { prose: _, ...table }] of await tables())
    expect(
      leavesOf(table).map(([path]) => path),
      language,
    ).toEqual(leavesOf(en).map(([path]) => path));
});

test("the numbers in a text are those of English", async () => {
  const english = new Map(leavesOf(en));
  for (const [language, { prose: _, ...table }] of await tables())
    for (const [path, leaf] of leavesOf(table)) {
      const source = english.get(path);
      if (typeof leaf !== "string" || typeof source !== "string") continue;
      if (/scene\.keys\.\d\.0$/.test(path)) continue; // names of keys, as the German Pos1
      expect(numbersIn(leaf), `${language}${path}`).toEqual(numbersIn(source));
      expect(leaf.trim() === "", `${language}${path}`).toBe(source.trim() === "");
    }
});

/** What the parameters of English functions may be, by their names; all others are texts. */
const GIVEN: Readonly<Record<string, readonly unknown[]>> = {
  body: BODIES,
  names: [["⟨one⟩", "⟨other⟩"]],
  side: ["left", "right"],
  when: ["before", "after"],
  until: ["turn", "fall", "end"],
  which: ["A", "B"],
  sign: [".", ","],
  ...Object.fromEntries(
    ["straight", "further", "beyond", "rolled", "flat", "untwisted", "isLocal"].map((name) => [
      name,
      [true, false],
    ]),
  ),
  count: [0, 1, 2, 42],
  step: [2],
};

const STATES: Readonly<Record<string, readonly string[]>> = {
  ".floor.survives": ["standing", "sliding_flat", "flying_level", "moving"],
};

/** Functions of one object or a list, which have tests of their own. */
const APART = [".verdict.story", ".flicks.summary"];

/** All lists of arguments for an English function. */
function argumentsOf(path: string, make: Function): unknown[][] {
  const [, list] = /^(?:\(([^)]*)\)|(\w+)) *=>/.exec(String(make))!.slice(0, 2);
  const names = (list ?? /^\w+/.exec(String(make))![0]).split(",").map((name) => name.trim());
  return names
    .filter((name) => name !== "")
    .map((name) => (name === "state" && STATES[path]) || GIVEN[name] || [`⟨${name}⟩`])
    .reduce<unknown[][]>(
      (lists, choices) => lists.flatMap((one) => choices.map((choice) => [...one, choice])),
      [[]],
    );
}

/** Marks in French with an ordinary space beside them, at which a line could break. */
const BREAKABLE = / [:;!?»]|« /;

const placesIn = (text: string) => [...text.matchAll(/⟨\w+⟩/g)].map(([one]) => one).sort();

test("each function makes a sentence in each case, with all that it is given", async () => {
  const others = (await tables()).map(
    ([language, { prose: _, ...table }]) => [language, new Map(leavesOf(table))] as const,
  );
  for (const [path, english] of leavesOf(en)) {
    if (typeof english === "string" || APART.includes(path)) continue;
    for (const given of argumentsOf(path, english) as never[][]) {
      const source = english(...given);
      for (const [language, leaves] of [["en", new Map([[path, english]])] as const, ...others]) {
        const text = (leaves.get(path) as typeof english)(...given);
        const what = `${language}${path}(${JSON.stringify(given)}): ${text}`;
        expect(text, what).not.toMatch(/undefined|\[object|true|false|NaN/);
        if (language === "fr") expect(text, what).not.toMatch(BREAKABLE);
        expect(placesIn(text.toUpperCase()), what).toEqual(placesIn(source.toUpperCase()));
      }
    }
  }
});

test("the story of a turn is told for each way in which it begins and ends", async () => {
  for (const [language, { verdict }] of await tables())
    for (const body of BODIES)
      for (const start of [undefined, "⟨start⟩"])
        for (const endsWith of ["maximum", "fall", "end"] as const)
          for (const way of ["none", "same", "other"] as const) {
            const turned = { start, end: "⟨end⟩", endsWith, angle: "⟨angle⟩", time: "⟨time⟩" };
            const text = verdict.story({ ...turned, body, itself: "⟨itself⟩", way });
            expect(text, language).not.toMatch(/undefined|\[object/);
            for (const part of ["⟨end⟩", "⟨angle⟩", "⟨time⟩", "⟨itself⟩", start ?? ""])
              expect(text, language).toContain(part);
          }
});

test("the flicks are counted on both sides, on one, and on none", async () => {
  for (const [language, { flicks }] of await tables())
    for (const made of [1, 2, 42])
      for (const fell of [true, false])
        for (const others of [0, 1, 3]) {
          const sides = [
            { side: "left", count: 20, angle: "⟨a⟩" },
            { side: "right", count: 0, angle: "" },
          ] as const;
          const text = flicks.summary(made, sides, fell, others);
          expect(text, language).not.toMatch(/undefined|\[object/);
          for (const part of [String(made), "20", "⟨a⟩"]) expect(text, language).toContain(part);
          if (others > 1) expect(text, language).toContain(String(others));
        }
});

test("French marks of punctuation stay with their words", async () => {
  const { prose, ...table } = await TABLES.fr();
  for (const [path, leaf] of [...leavesOf(table), ...leavesOf(prose)])
    if (typeof leaf === "string") expect(leaf, path).not.toMatch(BREAKABLE);
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

test("each text of index.html is in each language, with its numbers, formulas and links", async () => {
  const places = placesOfPage();
  expect(places.get("hand.symbols")).toBe(4);
  expect(places.get("disks-and-coins.text")).toBe(3);
  for (const [language, { prose }] of (await tables()) as [string, Table][]) {
    expect(Object.keys(prose).sort(), language).toEqual([...places.keys()].sort());
    for (const [name, text] of Object.entries(prose)) {
      const used = [...text.matchAll(/\{(\d)\}/g)].map(([, k]) => Number(k)).sort();
      const all = Array.from({ length: places.get(name)! }, (_, k) => k);
      expect(used, `${language}.${name}`).toEqual(all);
      expect(text.trim(), `${language}.${name}`).not.toBe("");
    }
  }
});

test("index.html chooses among the languages that there are", () => {
  const [, choices] = /\/\^\(([a-z|]+)\)\\b\//.exec(PAGE)!;
  expect(choices!.split("|")).toEqual([...LANGUAGES]);
});
