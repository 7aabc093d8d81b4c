// Every quantity that a visitor can set: its name in the URL, unit and bounds, with its words.
// The controls, the URL and the refusals are made from this table.

import type { Preset } from "../core/core";
import { words } from "../words/words";

export interface NumberField {
  kind: "number";
  label: string;
  /** Unit in which the number is shown, typed and stored in the set-up. */
  unit: string;
  initial: number;
  /** Bounds of the accepted values. */
  min: number;
  max: number;
  /** Whether the bounds themselves are excluded. */
  open?: boolean;
  /** Whether only whole numbers are accepted. */
  whole?: boolean;
  /** Ends and step of the slider; by default its ends are the bounds. */
  slider?: [low: number, high: number, step: number];
  /** Makes the slider logarithmic on both sides of 0; this is its smallest value. */
  finest?: number;
  /** Explains the quantity in a sentence. */
  help: string;
}

export interface ChoiceField {
  kind: "choice";
  label: string;
  initial: string;
  choices: Record<string, string>;
  help: string;
}

/** What a visitor recorded, as a text: accelerations (floor/ground.ts) or directions of falls (falls/tally.ts). */
export interface RecordField {
  kind: "record";
  label: string;
  initial: string;
  /** A regular expression that all of the text matches. */
  pattern: string;
}

/** The bodies that a visitor describes by numbers: by its parts, or by its mass and inertia. */
export type Described = "own" | "inertia";

export type BodyName = Preset | Described;

/** As many measured falls as a link holds. */
export const MOST_FALLS = 600;

/** Directions of falls as a link has them: numbers with at most one decimal, between underscores. */
const FALLS_PATTERN = String.raw`([0-9]{1,3}(\.[0-9])?(_[0-9]{1,3}(\.[0-9])?){0,${MOST_FALLS - 1}})?`;

export const FIELDS = {
  body: {
    kind: "choice",
    ...words.fields.body,
    initial: "can_2007",
  },
  fill: {
    kind: "number",
    ...words.fields.fill,
    unit: "%",
    initial: 0,
    min: 0,
    max: 100,
    slider: [0, 100, 1],
  },
  radius: {
    kind: "number",
    ...words.fields.radius,
    unit: "cm",
    initial: 5,
    min: 0.01,
    max: 1000,
    slider: [0.5, 20, 0.1],
  },
  length: {
    kind: "number",
    ...words.fields.length,
    unit: "cm",
    initial: 12,
    min: 0,
    max: 1000,
    slider: [0, 40, 0.1],
  },
  mass: {
    kind: "number",
    ...words.fields.mass,
    unit: "g",
    initial: 100,
    min: 0.001,
    max: 1e6,
    slider: [1, 2000, 1],
  },
  wall: {
    kind: "number",
    ...words.fields.wall,
    unit: "%",
    initial: 80,
    min: 0,
    max: 100,
    slider: [0, 100, 1],
  },
  base: {
    kind: "number",
    ...words.fields.base,
    unit: "%",
    initial: 10,
    min: 0,
    max: 100,
    slider: [0, 100, 1],
  },
  height: {
    kind: "number",
    ...words.fields.height,
    unit: "cm",
    initial: 6,
    min: 0,
    max: 1000,
    slider: [0, 20, 0.1],
  },
  transverse: {
    kind: "number",
    ...words.fields.transverse,
    unit: "cm²",
    initial: 25,
    min: 1e-9,
    max: 1e9,
    slider: [0.5, 200, 0.5],
  },
  axial: {
    kind: "number",
    ...words.fields.axial,
    unit: "cm²",
    initial: 15,
    min: 1e-9,
    max: 1e9,
    slider: [0.5, 200, 0.5],
  },
  tilt: {
    kind: "number",
    ...words.fields.tilt,
    unit: "°",
    initial: 20,
    min: 1e-6,
    max: 90,
    open: true,
    slider: [0.5, 89.5, 0.5],
  },
  tilt_rate: {
    kind: "number",
    ...words.fields.tilt_rate,
    unit: "rad/s",
    initial: 0,
    min: -1000,
    max: 1000,
    slider: [-10, 10, 0.1],
  },
  sideways: {
    kind: "number",
    ...words.fields.sideways,
    unit: "rad/s",
    initial: 0.0005,
    min: -1000,
    max: 1000,
    slider: [-0.5, 0.5, 0.001],
    finest: 1e-6,
  },
  twist: {
    kind: "number",
    ...words.fields.twist,
    unit: "rad/s",
    initial: 0,
    min: -1000,
    max: 1000,
    slider: [-10, 10, 0.1],
  },
  yaw: {
    kind: "number",
    ...words.fields.yaw,
    unit: "°",
    initial: 0,
    min: -360,
    max: 360,
    slider: [-180, 180, 1],
  },
  law: {
    kind: "choice",
    ...words.fields.law,
    initial: "coulomb",
  },
  friction: {
    kind: "number",
    ...words.fields.friction,
    unit: "",
    initial: 0.5,
    min: 0,
    max: 1e6,
    slider: [0, 1, 0.01],
  },
  rolling: {
    kind: "number",
    ...words.fields.rolling,
    unit: "",
    initial: 0,
    min: 0,
    max: 1,
    slider: [0, 0.0005, 0.00001],
  },
  restitution: {
    kind: "number",
    ...words.fields.restitution,
    unit: "",
    initial: 0,
    min: 0,
    max: 1,
    slider: [0, 1, 0.01],
  },
  gravity: {
    kind: "number",
    ...words.fields.gravity,
    unit: "m/s²",
    initial: 9.80665,
    min: 0,
    max: 1e4,
    open: true,
    slider: [0.1, 30, 0.1],
  },
  duration: {
    kind: "number",
    ...words.fields.duration,
    unit: "s",
    initial: 3,
    min: 0.001,
    max: 120,
    slider: [0.5, 20, 0.5],
  },
  floor: {
    kind: "choice",
    ...words.fields.floor,
    initial: "rest",
  },
  start: {
    kind: "choice",
    ...words.fields.start,
    initial: "tilted",
  },
  pulse: {
    kind: "choice",
    ...words.fields.pulse,
    initial: "sine",
  },
  shake: {
    kind: "number",
    ...words.fields.shake,
    unit: "m/s²",
    initial: 8,
    min: 0,
    max: 1000,
    slider: [0, 20, 0.1],
  },
  vertical: {
    kind: "number",
    ...words.fields.vertical,
    unit: "m/s²",
    initial: 0,
    min: -1000,
    max: 1000,
    slider: [-10, 10, 0.1],
  },
  period: {
    kind: "number",
    ...words.fields.period,
    unit: "s",
    initial: 0.5,
    min: 0.001,
    max: 100,
    slider: [0.05, 3, 0.05],
  },
  cycles: {
    kind: "number",
    ...words.fields.cycles,
    unit: "",
    initial: 1,
    min: 0.01,
    max: 1000,
    slider: [0.5, 10, 0.5],
  },
  direction: {
    kind: "number",
    ...words.fields.direction,
    unit: "°",
    initial: 0,
    min: -360,
    max: 360,
    slider: [-180, 180, 1],
  },
  flat: {
    kind: "choice",
    ...words.fields.flat,
    initial: "smooth_left",
  },
  record: {
    kind: "record",
    ...words.fields.record,
    initial: "",
    pattern: "([A-Za-z0-9_-]{4}){0,600}",
  },
  flicks: {
    kind: "number",
    ...words.fields.flicks,
    unit: "",
    initial: 42,
    min: 1,
    max: 1000,
    whole: true,
    slider: [1, 200, 1],
  },
  unsteadiness: {
    kind: "number",
    ...words.fields.unsteadiness,
    unit: "%",
    initial: 100,
    min: 0,
    max: 1000,
    slider: [0, 300, 5],
  },
  seed: {
    kind: "number",
    ...words.fields.seed,
    unit: "",
    initial: 1,
    min: 0,
    max: 4294967295,
    whole: true,
    slider: [1, 100, 1],
  },
  falls: {
    kind: "record",
    ...words.fields.falls,
    initial: "",
    pattern: FALLS_PATTERN,
  },
} as const satisfies Record<string, NumberField | ChoiceField | RecordField>;

export type FieldName = keyof typeof FIELDS;
export const FIELD_NAMES = Object.keys(FIELDS) as FieldName[];

/** Names of the playback settings in the URL, see playback.ts, and of a set-up that is compared. */
export type PlaybackName = "speed" | "slow" | "view" | "step" | "with";

/** What the names of a set-up that is compared begin with in the URL. */
export const OTHER = "with.";

/** Fields of the repeated release; a single motion does not depend on them. */
export const FLICK_FIELDS = [
  "flicks",
  "unsteadiness",
  "seed",
  "falls",
] as const satisfies readonly FieldName[];

/** Fields on which a single motion depends; only these are compared. */
export const MOTION_FIELDS: readonly FieldName[] = FIELD_NAMES.filter(
  (name) => !(FLICK_FIELDS as readonly string[]).includes(name),
);

/** Fields of the floor. */
export const FLOOR_FIELDS = [
  "floor",
  "start",
  "pulse",
  "shake",
  "vertical",
  "period",
  "cycles",
  "direction",
  "flat",
  "record",
] as const satisfies readonly FieldName[];

/** Fields that only some bodies have. */
export const BODY_FIELDS: Record<string, readonly FieldName[]> = {
  soda_can: ["fill"],
  beer_bottle: ["fill"],
  own: ["radius", "length", "mass", "wall", "base"],
  inertia: ["radius", "mass", "height", "transverse", "axial"],
};

// A refused value and the reason, for the visitor who typed it or followed a link that holds it.

export interface Refusal {
  field: FieldName | PlaybackName;
  /** The text as the visitor wrote it. */
  text: string;
  message: string;
}
