// The scenes of the essay: what each one shows, its one control, and what it says of the motion.

import { HAND_ERROR, type Setup } from "../setup/setup";
import type { Playback } from "../setup/playback";
import type { Line } from "./curve";
import { type Facts, cameUp, ranRound } from "./words";
import { formatDegrees, formatFixed, formatPrecise } from "../format/numbers";
import { say, words } from "../words/words";

/** A slider for a quantity. */
export interface Quantity {
  kind: "quantity";
  label: string;
  low: number;
  high: number;
  step: number;
  initial: number;
  /** Whether the slider is logarithmic; then it has a hundred steps. */
  logarithmic?: boolean;
  /** Values with names, below the slider. */
  marks?: Readonly<Record<string, number>>;
  /** A value as people read it. */
  words(value: number): string;
  setup(value: number): Partial<Setup>;
}

/** Buttons for some set-ups. */
export interface Choice {
  kind: "choice";
  label: string;
  options: readonly { name: string; setup: Partial<Setup> }[];
}

/** A guess of the angle of turn; the time of the motion; the body itself. */
export interface Special {
  kind: "guess" | "time" | "grasp";
}

export interface Scene {
  /** The # part of its address. */
  id: string;
  setup: Partial<Setup>;
  playback: Playback;
  control: Quantity | Choice | Special;
  /** Whether the motion plays when the scene first comes into view. */
  plays?: boolean;
  /** Whether it repeats the release and shows all falls. */
  flicks?: boolean;
  /** Whether it compares the motion with what the model leaves out. */
  limits?: boolean;
  /** A plot of angles of turn over the values of the control. */
  curve?: readonly Line[];
  /** Angles that the plot always contains, degrees. */
  include?: readonly number[];
  says(facts: Facts): string;
}

const angleOf = ({ angle }: Facts["passage"]) => formatDegrees(Math.abs(angle), 1);

/** Motions of the essay are short. */
const BRIEF: Partial<Setup> = { sideways: HAND_ERROR, duration: 1 };

const STRETCHED: Playback = { speed: 1, stretched: true, view: "whole" };

export const SCENES: readonly Scene[] = [
  {
    id: "question",
    setup: BRIEF,
    playback: { speed: 0.1, stretched: false, view: "whole" },
    control: { kind: "guess" },
    says: cameUp,
  },
  {
    id: "slap-or-roll",
    setup: { ...BRIEF, duration: 0.4 },
    playback: { ...STRETCHED, view: "contact" },
    control: { kind: "time" },
    plays: true,
    says: ranRound,
  },
  {
    id: "hand",
    setup: BRIEF,
    playback: STRETCHED,
    control: {
      kind: "quantity",
      label: words.essay.sideways,
      low: 0.001,
      high: 0.1,
      step: 1,
      initial: HAND_ERROR,
      logarithmic: true,
      words: (rate) => `${formatPrecise(rate, 2)} rad/s`,
      setup: (sideways) => ({ sideways }),
    },
    curve: [
      { name: words.essay.lines.turn, colour: "accent", of: "turn" },
      { name: words.essay.lines.limit, colour: "theory", of: "here", dashed: true },
    ],
    include: [180, 220],
    says: ({ passage, gap, time }) => say(words.essay.hand, { angle: angleOf(passage), gap, time }),
  },
  {
    id: "friction",
    setup: BRIEF,
    playback: STRETCHED,
    control: {
      kind: "quantity",
      label: words.essay.friction,
      low: 0,
      high: 0.8,
      step: 0.01,
      initial: 0.1,
      marks: {
        [words.controls.tables.ice]: 0.03,
        [words.controls.tables.wood]: 0.3,
        [words.controls.tables.rubber]: 0.8,
      },
      words: (friction) => formatFixed(friction, 2),
      setup: (friction) => ({ law: "coulomb", friction }),
    },
    plays: true,
    curve: [
      { name: words.essay.lines.here, colour: "theory", of: "here" },
      { name: words.essay.lines.noSlip, colour: "law-no_slip", of: "noSlip", dashed: true },
      {
        name: words.essay.lines.frictionless,
        colour: "law-frictionless",
        of: "frictionless",
        dashed: true,
      },
    ],
    says: ({ passage, theory }) =>
      say(words.essay.table, {
        angle: angleOf(passage),
        rolled: passage.rim === "rolled",
        limit: formatDegrees(theory.here, 1),
      }),
  },
  {
    id: "tall-and-flat",
    setup: {
      ...BRIEF,
      tilt: 10,
      body: "own",
      radius: 3,
      mass: 100,
      wall: 0,
      base: 0,
      law: "no_slip",
    },
    playback: STRETCHED,
    control: {
      kind: "quantity",
      label: words.essay.height,
      low: 0,
      high: 18,
      step: 0.1,
      initial: 9,
      words: (length) => `${formatFixed(length, 1)} cm`,
      setup: (length) => ({ length }),
    },
    curve: [{ name: words.essay.lines.noSlipLimit, colour: "law-no_slip", of: "noSlip" }],
    says: ({ passage, theory }) =>
      say(words.essay.cylinder, {
        angle: angleOf(passage),
        limit: formatDegrees(theory.noSlip, 1),
      }),
  },
  {
    id: "disks-and-coins",
    setup: { ...BRIEF, friction: 0.3 },
    playback: STRETCHED,
    control: {
      kind: "choice",
      label: words.essay.body,
      options: [
        { name: words.essay.bodies.coin, setup: { body: "coin" } },
        { name: words.essay.bodies.ring, setup: { body: "ring" } },
        { name: words.essay.bodies.battery, setup: { body: "battery", tilt: 10 } },
        { name: words.essay.bodies.bottle, setup: { body: "beer_bottle", tilt: 10 } },
      ],
    },
    plays: true,
    says: ({ passage, theory }) =>
      say(words.essay.limits, {
        angle: angleOf(passage),
        noSlip: formatDegrees(theory.noSlip, 1),
        frictionless: formatDegrees(theory.frictionless, 1),
      }),
  },
  {
    id: "experiment",
    setup: { tilt_rate: -5, sideways: HAND_ERROR, duration: 2, law: "coulomb" },
    playback: STRETCHED,
    control: {
      kind: "quantity",
      label: words.essay.friction,
      low: 0.01,
      high: 0.4,
      step: 0.01,
      initial: 0.3,
      words: (friction) => formatFixed(friction, 2),
      setup: (friction) => ({ friction }),
    },
    flicks: true,
    says: () => "",
  },
  {
    id: "left-out",
    setup: { ...BRIEF, rolling: 0 },
    playback: STRETCHED,
    control: {
      kind: "quantity",
      label: words.essay.sideways,
      low: 0.0001,
      high: 0.1,
      step: 1,
      initial: HAND_ERROR,
      logarithmic: true,
      words: (rate) => `${formatPrecise(rate, 2)} rad/s`,
      setup: (sideways) => ({ sideways }),
    },
    limits: true,
    says: () => "",
  },
  {
    id: "your-turn",
    setup: { sideways: HAND_ERROR },
    playback: STRETCHED,
    control: { kind: "grasp" },
    says: ranRound,
  },
];
