// The table of a comparison: what differs in the set-ups, and the numbers of both motions.

import type { Motion } from "../core/motion";
import type { Outcome } from "../simulation";
import { passageFrom } from "../verdict/passage";
import {
  formatDegrees,
  formatDuration,
  formatFixed,
  formatLengthShort,
  formatNumber,
  formatWide,
  significant,
  withUnit,
} from "../format";
import { BODY_FIELDS, type FieldName, FIELDS, FLOOR_FIELDS, MOTION_FIELDS } from "../setup/fields";
import type { Setup } from "../setup/setup";
import { say, words } from "../words/words";

/** Numbers of one motion, of its first turn unless they say otherwise; NaN where it has none. */
export interface Numbers {
  /** Angle through which the contact point ran round, rad. */
  turn: number;
  /** Rotation of the body itself in that direction, rad. */
  itself: number;
  /** Limiting turn on this table, rad. */
  limit: number;
  /** Smallest tilt, rad. */
  tilt: number;
  /** Gap under the highest point of the rim then, m. */
  gap: number;
  /** Time of the smallest tilt, s. */
  time: number;
  /** Time for most of the angle, s. */
  passage: number;
  /** Largest normal force over the weight. */
  force: number;
  /** Energy at the end of the turn over that at the start. Zero is the body flat at rest. */
  energy: number;
  /** End of the motion, s. */
  end: number;
}

export function numbersOf(outcome: Outcome | undefined): Numbers | undefined {
  if (!outcome || !("motion" in outcome)) return undefined;
  const { motion, theory, input } = outcome;
  const passage = passageFrom(motion, 0);
  const lowest = motion.turns[0]?.t ?? firstLowest(motion);
  return {
    turn: Math.abs(passage?.angle ?? NaN),
    itself: passage ? passage.bodyAngle * (Math.sign(passage.angle) || 1) : NaN,
    limit: theory.here,
    tilt: passage?.minTilt ?? NaN,
    gap: passage?.validity.gap ?? NaN,
    time: lowest,
    passage: passage?.validity.passageTime ?? NaN,
    force: passage?.validity.forceRatio ?? NaN,
    energy: input.shaking ? NaN : energyKept(motion, passage?.end ?? motion.end),
    end: motion.end,
  };
}

const firstLowest = (motion: Motion) =>
  motion.events.find(({ kind }) => kind === "tilt_min")?.moment.t ?? NaN;

/** Part of the energy that is left at a time (s); the core counts it from the body flat at rest. */
function energyKept(motion: Motion, time: number): number {
  const [before, after] = [0, time].map((t) => {
    const { kinetic_energy, potential_energy } = motion.at([t]).moment(0);
    return kinetic_energy + potential_energy;
  }) as [number, number];
  return before > 0 ? after / before : NaN;
}

// The table of a comparison: what differs in the set-ups, and the numbers of both motions.

export interface Row {
  name: string;
  a: string;
  b: string;
  /** How B differs from A; empty where that says nothing. */
  difference: string;
}

/** The fields in which two set-ups differ, of those that one of them uses. */
export function setupRows(a: Readonly<Setup>, b: Readonly<Setup>): Row[] {
  return MOTION_FIELDS.filter((name) => a[name] !== b[name])
    .filter((name) => isUsed(name, a) || isUsed(name, b))
    .map((name) => ({
      name: FIELDS[name].label,
      a: isUsed(name, a) ? valueOf(name, a) : "–",
      b: isUsed(name, b) ? valueOf(name, b) : "–",
      difference: "",
    }));
}

/** Fields that matter under dry friction only. */
const OF_FRICTION: readonly FieldName[] = ["friction", "restitution"];
const OF_BODIES: readonly FieldName[] = Object.values(BODY_FIELDS).flat();

/** Whether the motion of a set-up can depend on a field. */
function isUsed(name: FieldName, setup: Readonly<Setup>): boolean {
  if (OF_BODIES.includes(name)) return BODY_FIELDS[setup.body]?.includes(name) ?? false;
  if (OF_FRICTION.includes(name)) return setup.law === "coulomb";
  const ofFloor: readonly FieldName[] = FLOOR_FIELDS;
  return name === "floor" || !ofFloor.includes(name) || setup.floor !== "rest";
}

function valueOf(name: FieldName, setup: Readonly<Setup>): string {
  const [field, value] = [FIELDS[name], setup[name]];
  if (field.kind === "choice")
    return (field.choices as Record<string, string>)[String(value)] ?? String(value);
  return field.kind === "number" ? withUnit(formatNumber(Number(value)), field.unit) : "…";
}

/** How a number is written, and how two are compared. */
interface Style {
  text(value: number): string;
  difference(a: number, b: number): string;
}

/** A difference with its sign; zero has none. */
const signed = (text: string) => (/^−|^[0.,]+\D*$/.test(text) ? text : `+${text}`);

/** The difference of the rounded numbers, as a reader would subtract them. */
function inDegrees(decimals: number): Style {
  const rounded = (angle: number) =>
    Number(((angle * 180) / Math.PI).toFixed(decimals)) * (Math.PI / 180);
  return {
    text: (angle) => formatDegrees(angle, decimals),
    difference: (a, b) => signed(formatDegrees(rounded(b) - rounded(a), decimals)),
  };
}

/** Numbers that differ by a factor. */
const byFactor = (text: (value: number) => string): Style => ({
  text,
  difference: (a, b) =>
    a > 0 && b > 0 ? say(words.compare.times, { ratio: formatWide(b / a, 2) }) : "",
});

const percent: Style = {
  text: (part) => `${formatFixed(100 * part, 1)}\u00a0%`,
  difference: (a, b) => {
    const points = Math.round(1000 * b) / 10 - Math.round(1000 * a) / 10;
    return `${signed(formatFixed(points, 1))}\u00a0%`;
  },
};

const STYLES: Record<keyof Numbers, Style> = {
  turn: inDegrees(1),
  itself: inDegrees(1),
  limit: inDegrees(1),
  tilt: byFactor((tilt) => `${formatWide((tilt * 180) / Math.PI, 2)}°`),
  gap: byFactor(formatLengthShort),
  time: byFactor(formatDuration),
  passage: byFactor(formatDuration),
  force: byFactor((ratio) => significant(ratio, 2)),
  energy: percent,
  end: byFactor(formatDuration),
};

/** The numbers of both motions; a number that neither has is left out. */
export function numberRows(a: Numbers | undefined, b: Numbers | undefined): Row[] {
  const names = Object.keys(STYLES) as (keyof Numbers)[];
  return names
    .map((name) => ({ name, mine: a?.[name] ?? NaN, other: b?.[name] ?? NaN }))
    .filter(({ mine, other }) => !(Number.isNaN(mine) && Number.isNaN(other)))
    .map(({ name, mine, other }) => {
      const { text, difference } = STYLES[name];
      const written = (value: number) => (Number.isNaN(value) ? "–" : text(value));
      const comparable = !Number.isNaN(mine) && !Number.isNaN(other);
      return {
        name: words.compare.rows[name],
        a: written(mine),
        b: written(other),
        difference: comparable ? difference(mine, other) : "",
      };
    });
}
