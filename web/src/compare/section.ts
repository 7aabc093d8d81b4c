// The section that compares two motions: buttons that choose them, and a table of both.

import { batch, computed, effect } from "@preact/signals-core";
import { button, element } from "../elements";
import { formatDegrees } from "../format";
import type { Lab } from "../lab";
import type { Outcome } from "../simulation";
import { say, words } from "../words/words";
import "./compare.css";
import { numberRows, numbersOf, type Row, setupRows } from "./table";
import { HAND_ERROR, type Setup } from "../setup/setup";

const texts = words.compare;

export function mountCompare(lab: Lab, place: HTMLElement): void {
  const start = (name: PresetName) => {
    const { part, other } = PRESETS[name](lab.setup.value);
    lab.compare(other, part);
    if (name !== "keep") playFirstTurns(lab);
  };
  const names = Object.keys(PRESETS) as PresetName[];
  const presets = names.map((name) => button(texts.presets[name], () => start(name)));
  const stop = button(texts.stop, () => {
    lab.compare(undefined);
    // This button disappears, so the focus must move.
    presets[0]?.focus();
  });
  const said = element("p", { class: "said", role: "status" });
  const table = element("table");
  const result = element(
    "div",
    { class: "result" },
    element(
      "p",
      { class: "key" },
      element("span", { class: "a" }, texts.keyA),
      element("span", { class: "b" }, texts.keyB),
    ),
    said,
    element(
      "div",
      { class: "table", tabindex: 0, role: "group", "aria-label": texts.title },
      table,
    ),
    element(
      "div",
      { class: "row" },
      button(texts.swap, () => swap(lab)),
      stop,
    ),
  );
  place.append(
    element("h2", {}, texts.title),
    element("p", { class: "hint" }, texts.help),
    element("div", { class: "row presets", role: "group", "aria-label": texts.title }, ...presets),
    result,
  );
  fill(lab, result, said, table);
}

/** Plays until both bodies have come up. */
function playFirstTurns(lab: Lab): void {
  lab.whenComplete(() => {
    const ends = [lab.motion.value, lab.other.motion.value].map(
      (motion) => motion?.turns[0]?.end ?? motion?.end ?? 0,
    );
    lab.clock.play(Math.max(...ends));
  });
}

function swap(lab: Lab): void {
  const other = lab.otherSetup.value;
  if (other) lab.compare(lab.setup.value, other);
}

/** Keeps the words and the table up to date. */
function fill(lab: Lab, result: HTMLElement, said: HTMLElement, table: HTMLElement): void {
  const a = computed(() => numbersOf(lab.outcome.value));
  const b = computed(() => numbersOf(lab.other.outcome.value));
  const differing = computed(() =>
    lab.otherSetup.value ? setupRows(lab.setup.value, lab.otherSetup.value) : [],
  );
  effect(() => {
    const other = lab.otherSetup.value;
    batch(() => {
      result.hidden = !other;
      if (!other) return;
      const ends = row(endings(lab.outcome.value, lab.other.outcome.value));
      table.replaceChildren(
        head(),
        body(texts.setup, differing.value.map(row)),
        body(texts.turn, [...numberRows(a.value, b.value).map(row), ends]),
      );
    });
  });
  effect(() => {
    const text = sentence(lab, differing.value.length > 0);
    // An unchanged text must not be read out again.
    if (said.textContent !== text) said.textContent = text;
  });

  function sentence({ outcome, other, otherSetup }: Lab, differ: boolean): string {
    if (!otherSetup.value || !other.outcome.value) return "";
    for (const [which, one] of [
      ["A", outcome.value],
      ["B", other.outcome.value],
    ] as const)
      if ("refused" in one) return say(texts.refused, { which, why: one.refused });
    if (!differ) return texts.same;
    return compared(a.value?.turn ?? NaN, b.value?.turn ?? NaN);
  }
}

/** Both turns (rad) in a sentence. */
function compared(a: number, b: number): string {
  const [mine, others] = [formatDegrees(a, 1), formatDegrees(b, 1)];
  if (Number.isNaN(a) || Number.isNaN(b)) return texts.none;
  if (mine === others) return say(texts.equal, { angle: mine });
  // The difference of the rounded angles, as a reader would subtract them.
  const tenths = (angle: number) => Math.round((angle * 1800) / Math.PI);
  const apart = ((tenths(b) - tenths(a)) * Math.PI) / 1800;
  return say(texts.turns, {
    a: mine,
    b: others,
    apart: formatDegrees(Math.abs(apart), 1),
    further: apart > 0,
  });
}

/** How both motions end. */
function endings(a: Outcome | undefined, b: Outcome | undefined): Row {
  const known: Readonly<Record<string, string>> = texts.endings;
  const word = (outcome: Outcome | undefined) =>
    outcome && "motion" in outcome ? (known[outcome.motion.status] ?? "–") : "–";
  return { name: texts.ending, a: word(a), b: word(b), difference: "" };
}

const head = () =>
  element(
    "thead",
    {},
    element(
      "tr",
      {},
      element("td"),
      ...["A", "B", texts.difference].map((name) => element("th", { scope: "col" }, name)),
    ),
  );

/** Rows under a heading; nothing if there are none. */
function body(name: string, rows: HTMLElement[]): HTMLElement | string {
  if (rows.length === 0) return "";
  const heading = element("th", { scope: "rowgroup", colspan: 4 }, name);
  return element("tbody", {}, element("tr", { class: "group" }, heading), ...rows);
}

const row = ({ name, a, b, difference }: Row) =>
  element(
    "tr",
    {},
    element("th", { scope: "row" }, name),
    ...[a, b, difference].map((text) => element("td", {}, text)),
  );

// Pairs of set-ups that are worth a look.

/** A comparison: changes of the set-up A, and the set-up B beside it. */
export interface Pair {
  part: Partial<Setup>;
  other: Setup;
}

/** A start by hand, whose smallest gap a real table could have. */
const BY_HAND: Partial<Setup> = { sideways: HAND_ERROR, duration: 2 };

const START: Partial<Setup> = { ...BY_HAND, tilt: 20, tilt_rate: 0, twist: 0, floor: "rest" };

export const PRESETS = {
  /** One can on two tables: its rim slips on the first and rolls on the second. */
  ice: (setup: Readonly<Setup>): Pair =>
    pair(setup, { ...START, law: "coulomb", rolling: 0 }, { friction: 0.03 }, { friction: 0.8 }),
  /** Two bodies on one table. */
  coin: (setup: Readonly<Setup>): Pair =>
    pair(
      setup,
      { ...START, law: "coulomb", friction: 0.5 },
      { body: "can_2007" },
      { body: "coin" },
    ),
  /** The same start with the error to the other side. */
  mirror: (setup: Readonly<Setup>): Pair => ({ part: {}, other: mirrored(setup) }),
  /** The motion stays as it is while the visitor changes the set-up. */
  keep: (setup: Readonly<Setup>): Pair => ({ part: {}, other: { ...setup } }),
} as const;

export type PresetName = keyof typeof PRESETS;

function pair(
  setup: Readonly<Setup>,
  both: Partial<Setup>,
  a: Partial<Setup>,
  b: Partial<Setup>,
): Pair {
  return { part: { ...both, ...a }, other: { ...setup, ...both, ...b } };
}

/** The start seen in a mirror that stands upright along the lean. A floor that moves stays as it is. */
export const mirrored = (setup: Readonly<Setup>): Setup => ({
  ...setup,
  sideways: -setup.sideways || 0,
  twist: -setup.twist || 0,
});
