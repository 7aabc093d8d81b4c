// Every quantity that a visitor can set: its name in the URL, label, unit, bounds and help text.
// The controls, the URL and the refusals are made from this table.

import type { LawName, Preset } from "../core/core";

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

/** Accelerations that a visitor recorded, as a text; see floor/record.ts. */
export interface RecordField {
  kind: "record";
  label: string;
  initial: string;
  /** A regular expression that all of the text matches. */
  pattern: string;
}

/** The bodies that a visitor describes by numbers: by its parts, or by its mass and inertia. */
export type Described = "own" | "inertia";

const BODIES: Record<Preset | Described, string> = {
  can_2007: "The paper's can",
  soda_can: "Soda can",
  beer_bottle: "Beer bottle",
  coin: "Coin (1 euro)",
  ring: "Ring",
  battery: "Battery (AA)",
  euler_disk: "Euler's disk",
  own: "Your own",
  inertia: "By its inertia",
};

/** Nouns for the bodies in a sentence. */
export const BODY_NOUNS: Record<Preset | Described, string> = {
  can_2007: "can",
  soda_can: "can",
  beer_bottle: "bottle",
  coin: "coin",
  ring: "ring",
  battery: "battery",
  euler_disk: "disk",
  own: "body",
  inertia: "body",
};

const LAW_NAMES: Record<LawName, string> = {
  frictionless: "No friction",
  coulomb: "Dry friction",
  no_slip: "No slip",
};

export const FIELDS = {
  body: {
    kind: "choice",
    label: "Body",
    initial: "can_2007",
    choices: BODIES,
    help: "The body that stands on the table.",
  },
  fill: {
    kind: "number",
    label: "Filled",
    unit: "%",
    initial: 0,
    min: 0,
    max: 100,
    slider: [0, 100, 1],
    help: "How full the can or bottle is. The drink moves with it like a solid.",
  },
  radius: {
    kind: "number",
    label: "Radius",
    unit: "cm",
    initial: 5,
    min: 0.01,
    max: 1000,
    slider: [0.5, 20, 0.1],
    help: "Radius of the rim.",
  },
  length: {
    kind: "number",
    label: "Height",
    unit: "cm",
    initial: 12,
    min: 0,
    max: 1000,
    slider: [0, 40, 0.1],
    help: "From base to top. 0 is a flat disk.",
  },
  mass: {
    kind: "number",
    label: "Mass",
    unit: "g",
    initial: 100,
    min: 0.001,
    max: 1e6,
    slider: [1, 2000, 1],
    help: "Total mass. No angle of turn depends on it.",
  },
  wall: {
    kind: "number",
    label: "Mass in the wall",
    unit: "%",
    initial: 80,
    min: 0,
    max: 100,
    slider: [0, 100, 1],
    help: "Share of the mass above the base plate: 0 is a solid cylinder, 100 a thin tube.",
  },
  base: {
    kind: "number",
    label: "Mass in the base",
    unit: "%",
    initial: 10,
    min: 0,
    max: 100,
    slider: [0, 100, 1],
    help: "Share of the total mass, in a thin plate at the bottom.",
  },
  height: {
    kind: "number",
    label: "Centre of mass",
    unit: "cm",
    initial: 6,
    min: 0,
    max: 1000,
    slider: [0, 20, 0.1],
    help: "Height of the centre of mass above the base. 0 is a flat disk.",
  },
  transverse: {
    kind: "number",
    label: "A/m",
    unit: "cm²",
    initial: 25,
    min: 1e-9,
    max: 1e9,
    slider: [0.5, 200, 0.5],
    help: "Moment of inertia about a line through the centre of mass across the body, over the mass.",
  },
  axial: {
    kind: "number",
    label: "C/m",
    unit: "cm²",
    initial: 15,
    min: 1e-9,
    max: 1e9,
    slider: [0.5, 200, 0.5],
    help: "Moment of inertia about the body's axis, over the mass. No rigid body has more than 2 A/m.",
  },
  tilt: {
    kind: "number",
    label: "Tilt",
    unit: "°",
    initial: 20,
    min: 1e-6,
    max: 90,
    open: true,
    slider: [0.5, 89.5, 0.5],
    help: "How far the body leans when it is released.",
  },
  tilt_rate: {
    kind: "number",
    label: "Tilt rate",
    unit: "rad/s",
    initial: 0,
    min: -1000,
    max: 1000,
    slider: [-10, 10, 0.1],
    help: "0 releases the body at rest. A negative rate flicks it toward upright.",
  },
  sideways: {
    kind: "number",
    label: "Sideways error",
    unit: "rad/s",
    initial: 0.0005,
    min: -1000,
    max: 1000,
    slider: [-0.5, 0.5, 0.001],
    finest: 1e-6,
    help: "How fast the body also turns about the line along which it leans. No hand avoids this error.",
  },
  twist: {
    kind: "number",
    label: "Twist",
    unit: "rad/s",
    initial: 0,
    min: -1000,
    max: 1000,
    slider: [-10, 10, 0.1],
    help: "How fast the body also turns about the vertical.",
  },
  yaw: {
    kind: "number",
    label: "Leans toward",
    unit: "°",
    initial: 0,
    min: -360,
    max: 360,
    slider: [-180, 180, 1],
    help: "The direction of the lean on the table. The whole motion turns with it.",
  },
  law: {
    kind: "choice",
    label: "Table",
    initial: "coulomb",
    choices: LAW_NAMES,
    help: "No friction and no slip are the paper's two ideal laws.",
  },
  friction: {
    kind: "number",
    label: "Friction",
    unit: "",
    initial: 0.5,
    min: 0,
    max: 1e6,
    slider: [0, 1, 0.01],
    help: "Coefficient of friction μ: largest friction force over normal force.",
  },
  rolling: {
    kind: "number",
    label: "Rolling resistance",
    unit: "",
    initial: 0,
    min: 0,
    max: 1,
    slider: [0, 0.01, 0.0001],
    help: "Resisting force over normal force. It slows the motion down.",
  },
  restitution: {
    kind: "number",
    label: "Bounce",
    unit: "",
    initial: 0,
    min: 0,
    max: 1,
    slider: [0, 1, 0.01],
    help: "Coefficient of restitution when the rim lands after it has left the table.",
  },
  gravity: {
    kind: "number",
    label: "Gravity",
    unit: "m/s²",
    initial: 9.80665,
    min: 0,
    max: 1e4,
    open: true,
    slider: [0.1, 30, 0.1],
    help: "9.81 on Earth, 1.62 on the Moon.",
  },
  duration: {
    kind: "number",
    label: "Duration",
    unit: "s",
    initial: 3,
    min: 0.001,
    max: 120,
    slider: [0.5, 20, 0.5],
    help: "The time for which the motion is computed.",
  },
  floor: {
    kind: "choice",
    label: "Floor",
    initial: "rest",
    choices: { rest: "At rest", pulse: "A pulse", hand: "By hand" },
    help: "Whether the floor moves. The table moves with it, and does not turn.",
  },
  start: {
    kind: "choice",
    label: "Start",
    initial: "tilted",
    choices: { tilted: "Leaning", standing: "Standing flat" },
    help: "Whether the body leans at first or stands flat on its base.",
  },
  pulse: {
    kind: "choice",
    label: "Shape",
    initial: "sine",
    choices: {
      sine: "Sine",
      cosine: "Cosine",
      half_sine: "Half sine",
      ricker: "Ricker wavelet",
      rectangular: "Rectangle",
    },
    help: "The floor's acceleration over time.",
  },
  shake: {
    kind: "number",
    label: "Amplitude",
    unit: "m/s²",
    initial: 8,
    min: 0,
    max: 1000,
    slider: [0, 20, 0.1],
    help: "Largest horizontal acceleration. 9.81 is the gravity on Earth, 1 g.",
  },
  vertical: {
    kind: "number",
    label: "Vertical",
    unit: "m/s²",
    initial: 0,
    min: -1000,
    max: 1000,
    slider: [-10, 10, 0.1],
    help: "Largest vertical acceleration; positive is upward at first.",
  },
  period: {
    kind: "number",
    label: "Period",
    unit: "s",
    initial: 0.5,
    min: 0.001,
    max: 100,
    slider: [0.05, 3, 0.05],
    help: "Time of one oscillation; for a half sine and a rectangle, the time until it ends.",
  },
  cycles: {
    kind: "number",
    label: "Cycles",
    unit: "",
    initial: 1,
    min: 0.01,
    max: 1000,
    slider: [0.5, 10, 0.5],
    help: "Number of oscillations of a sine or a cosine.",
  },
  direction: {
    kind: "number",
    label: "Direction",
    unit: "°",
    initial: 0,
    min: -360,
    max: 360,
    slider: [-180, 180, 1],
    help: "The direction of the horizontal acceleration, as in “Leans toward”.",
  },
  flat: {
    kind: "choice",
    label: "Flat landing",
    initial: "smooth_left",
    choices: {
      stop: "The motion ends",
      smooth_left: "Runs round to the left",
      smooth_right: "Runs round to the right",
      housner: "Housner’s impact",
    },
    help: "What follows where the whole base comes down at once, which rigid-body mechanics does not determine.",
  },
  record: { kind: "record", label: "Record", initial: "", pattern: "([A-Za-z0-9_-]{4}){0,600}" },
  flicks: {
    kind: "number",
    label: "Flicks",
    unit: "",
    initial: 42,
    min: 1,
    max: 1000,
    whole: true,
    slider: [1, 200, 1],
    help: "How many times the release is repeated. The paper: 42.",
  },
  unsteadiness: {
    kind: "number",
    label: "Unsteadiness of the hand",
    unit: "%",
    initial: 100,
    min: 0,
    max: 1000,
    slider: [0, 300, 5],
    help: "At 100, a flick misses the middle by about 3°.",
  },
  seed: {
    kind: "number",
    label: "Seed",
    unit: "",
    initial: 1,
    min: 0,
    max: 4294967295,
    whole: true,
    slider: [1, 100, 1],
    help: "Seed of the random numbers. The same seed gives the same scatter.",
  },
} as const satisfies Record<string, NumberField | ChoiceField | RecordField>;

export type FieldName = keyof typeof FIELDS;
export const FIELD_NAMES = Object.keys(FIELDS) as FieldName[];

/** Names of the playback settings in the URL; see playback.ts. */
export type PlaybackName = "speed" | "slow" | "view" | "step";

/** Fields of the repeated release; a single motion does not depend on them. */
export const FLICK_FIELDS = [
  "flicks",
  "unsteadiness",
  "seed",
] as const satisfies readonly FieldName[];

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
