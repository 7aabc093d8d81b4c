// A histogram of the angles of turn on a straight axis, with the limits of theory and the paper's
// measurements. Falls to the left of the hand are filled bars upward, to the right hollow bars downward.

import type { Theory } from "../core/core";
import { MEASURED, type Tally, tallyOf } from "./tally";
import { formatFixed } from "../format";
import { say, sentences, words } from "../words/words";
import { computed, effect } from "@preact/signals-core";
import { element, svgElement } from "../elements";
import { flickSummary } from "./shown";
import type { Lab } from "../lab";

/** Size of the picture, with room for labels above, degrees in the middle, and counts. */
export const [WIDTH, HEIGHT] = [360, 154];
const [TOP, AXIS, BAND, BOTTOM] = [18, 78, 16, HEIGHT - 2];
const TALLEST = AXIS - BAND / 2 - TOP - 6;
/** Labels of two limits overlap if their lines are nearer than this. */
const LABEL_WIDTH = 110;

export interface Shown {
  tally: Tally;
  theory: Theory | undefined;
  bins: Bins;
  /** Whether the paper's measurements apply to this body. */
  measured: boolean;
}

/** The picture as the inside of an SVG of that size. */
export function humps({ tally, theory, bins, measured }: Shown): string {
  const place = (angle: number) => (WIDTH * (angle - bins.from)) / (bins.to - bins.from);
  const [left, right] = [binned(tally.left.turns, bins), binned(tally.right.turns, bins)];
  const highest = Math.max(4, ...left.bins, ...right.bins);
  return [
    limits(theory, place),
    degrees(bins, place),
    bars(left, "left", -TALLEST / highest, AXIS - BAND / 2),
    bars(right, "right", TALLEST / highest, AXIS + BAND / 2),
    ...(measured ? [paper(place, "left", TOP + 1), paper(place, "right", BOTTOM - 5)] : []),
    `<text x="0" y="${TOP + 10}" class="side">${say(words.story.left, { count: tally.left.count })}</text>`,
    `<text x="0" y="${BOTTOM - 2}" class="side">${say(words.story.right, { count: tally.right.count })}</text>`,
  ].join("");
}

function bars({ below, bins, above }: Counts, side: string, unit: number, foot: number): string {
  const width = WIDTH / bins.length;
  const bar = (count: number, k: number) => {
    const height = Math.abs(unit * count);
    const top = unit < 0 ? foot - height : foot;
    return count === 0
      ? ""
      : `<rect class="bar ${side}" x="${fixed(k * width + 0.6)}" y="${fixed(top)}" width="${fixed(width - 1.2)}" height="${fixed(height)}"/>`;
  };
  // Falls beyond an end of the axis are counted at that end.
  const beyond = (count: number, x: number, anchor: string, words: string) =>
    count === 0
      ? ""
      : `<text x="${x}" y="${foot + (unit < 0 ? -4 : 11)}" class="beyond" text-anchor="${anchor}">${words}</text>`;
  return [
    ...bins.map(bar),
    beyond(below, 0, "start", `◂ ${below}`),
    beyond(above, WIDTH, "end", `${above} ▸`),
  ].join("");
}

function degrees({ from, to, width }: Bins, place: (angle: number) => number): string {
  const step = 5 * width;
  const marks: string[] = [];
  for (let angle = from; angle <= to; angle += step) {
    const x = fixed(place(angle));
    const anchor = angle === from ? "start" : angle + step > to ? "end" : "middle";
    marks.push(
      `<path class="tick" d="M${x} ${AXIS - BAND / 2}v2.5M${x} ${AXIS + BAND / 2}v-2.5"/>`,
      `<text x="${x}" y="${AXIS + 4}" class="degrees" text-anchor="${anchor}">${angle}°</text>`,
    );
  }
  const line = (y: number) => `<path class="axis" d="M0 ${y}H${WIDTH}"/>`;
  return line(AXIS - BAND / 2) + line(AXIS + BAND / 2) + marks.join("");
}

function limits(theory: Theory | undefined, place: (angle: number) => number): string {
  if (!theory) return "";
  const all = [
    { angle: theory.noSlip, kind: "no-slip", name: words.essay.lines.noSlip },
    { angle: theory.frictionless, kind: "frictionless", name: words.essay.lines.frictionless },
  ]
    .filter(({ angle }) => !Number.isNaN(angle))
    .map((one) => ({ ...one, x: place(one.angle * DEGREES) }))
    .sort((one, other) => one.x - other.x);
  const [first, second] = all;
  const close = first && second && second.x - first.x < LABEL_WIDTH;
  return all
    .map(({ angle, kind, name, x }, k) => {
      const anchor = close ? (k === 0 ? "end" : "start") : "middle";
      return (
        `<path class="limit ${kind}" d="M${fixed(x)} ${TOP - 4}V${BOTTOM}"/>` +
        `<text x="${fixed(x)}" y="10" class="name" text-anchor="${anchor}">${name} ${formatFixed(angle * DEGREES, 1)}°</text>`
      );
    })
    .join("");
}

/** A bar from one standard deviation below the mean to one above, and a dot at the mean. */
function paper(place: (angle: number) => number, side: "left" | "right", y: number): string {
  const { mean, deviation } = MEASURED[side];
  const [from, to] = [fixed(place(mean - deviation)), fixed(place(mean + deviation))];
  return `<path class="measured" d="M${from} ${y}H${to}"/><circle class="mean" cx="${fixed(place(mean))}" cy="${y}" r="2.6"/>`;
}

const DEGREES = 180 / Math.PI;
const fixed = (length: number) => length.toFixed(1);

// The axis of a straight histogram of angles of turn, which contains the limits of theory.

/** A range divided into bins, degrees. */
export interface Bins {
  from: number;
  to: number;
  width: number;
}

/** Numbers of falls in each bin and beyond the ends of the axis. */
export interface Counts {
  below: number;
  bins: number[];
  above: number;
}

/** Margin beyond the limits and unit to which the ends are rounded, degrees. */
const [ROOM, ROUND] = [7, 5];
/** More bins than this could not be distinguished. */
const MAX_BINS = 60;
/** Percentage of the falls that may lie beyond the axis at either end. */
const MAX_OUTSIDE = 5;

/** An axis that contains the limits and nearly all of the turns (degrees, without sign). */
export function binsFor(theory: Theory | undefined, turns: readonly number[]): Bins {
  const limits = limitsOf(theory);
  const sorted = [...turns].sort((a, b) => a - b);
  const stray = Math.floor((sorted.length * MAX_OUTSIDE) / 100);
  const usual = sorted.slice(stray, sorted.length - stray);
  const held = [...limits.map((limit) => limit - ROOM), ...limits.map((limit) => limit + ROOM)];
  const ends = [...held, ...usual.slice(0, 1), ...usual.slice(-1)];
  if (ends.length === 0) return { from: 180, to: 180 + MAX_BINS, width: 1 };
  const from = ROUND * Math.floor(Math.min(...ends) / ROUND);
  const to = ROUND * Math.ceil((Math.max(...ends) + 1e-9) / ROUND);
  const width = [1, 2, 5, 10].find((width) => to - from <= MAX_BINS * width) ?? 20;
  // The range is a whole number of bins.
  return { from, to: from + width * Math.ceil((to - from) / width), width };
}

/** Limiting turns under the two ideal laws, degrees. */
export const limitsOf = (theory: Theory | undefined): number[] =>
  theory
    ? [theory.noSlip, theory.frictionless]
        .filter((limit) => !Number.isNaN(limit))
        .map((limit) => (limit * 180) / Math.PI)
    : [];

/** Counts the turns in bins that include their lower end but not their upper one. */
export function binned(turns: readonly number[], { from, to, width }: Bins): Counts {
  const bins = new Array<number>(Math.round((to - from) / width)).fill(0);
  let [below, above] = [0, 0];
  for (const turn of turns) {
    if (turn < from) below++;
    else if (turn >= to) above++;
    else bins[Math.floor((turn - from) / width)]! += 1;
  }
  return { below, bins, above };
}

/** The histogram of the flicks that are shown, with a caption. It is kept up to date while `isShown`, which reads
 * signals. */
export function fallsOf(lab: Lab, isShown: () => boolean): HTMLElement {
  const picture = svgElement("svg", {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    role: "img",
    "aria-label": words.flicks.title, // until it is shown
  });
  const caption = element("p", { class: "caption" });
  // The range covers all falls, so that the axis does not move while they appear.
  const bins = computed(() => {
    const { left, right } = tallyOf(lab.flicks.value);
    return binsFor(lab.theory.value, [...left.turns, ...right.turns]);
  });
  effect(() => {
    if (!isShown()) return;
    const theory = lab.theory.value;
    const measured = lab.setup.value.body === "can_2007";
    const tally = tallyOf(lab.flicks.value.slice(0, lab.flicksShown.value ?? 0));
    picture.innerHTML = humps({ tally, theory, bins: bins.value, measured });
    const [from, to, width] = [bins.value.from, bins.value.to, bins.value.width].map(
      (degrees) => `${degrees}°`,
    ) as [string, string, string];
    picture.setAttribute(
      "aria-label",
      sentences(say(words.story.histogram, { from, to, width }), flickSummary(lab)),
    );
    caption.textContent = sentences(
      say(words.story.caption, { width }),
      measured ? words.story.measured : "",
    );
  });
  return element("div", { class: "falls" }, picture as unknown as HTMLElement, caption);
}
