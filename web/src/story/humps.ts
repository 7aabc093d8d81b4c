// A histogram of the angles of turn on a straight axis, with the limits of theory and the paper's
// measurements. Falls to the left of the hand are filled bars upward, to the right hollow bars downward.

import type { Theory } from "../core/core";
import { MEASURED } from "../falls/paper";
import type { Tally } from "../falls/tally";
import { type Bins, type Counts, binned } from "./bins";
import { formatFixed } from "../format/numbers";
import { say, words } from "../words/words";

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
