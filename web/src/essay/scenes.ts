// The scenes of the essay: what each one shows, its one control, and what the essay says of the motion.

import { HAND_ERROR, INITIAL, type Setup } from "../setup/setup";
import type { Playback } from "../setup/playback";
import type { Line } from "./curve";
import {
  formatDegrees,
  formatDuration,
  formatFixed,
  formatLengthShort,
  formatPrecise,
} from "../format";
import { say, sentences, words } from "../words/words";
import type { Core, Theory } from "../core/core";
import { type Passage, passageFrom } from "../verdict/passage";
import { MEASURED } from "../falls/tally";
import { bodyOf, contactLawOf, simulationInput, startOf } from "../setup/simulation_input";

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

// What the essay says of a motion, in words.

export interface Facts {
  passage: Passage;
  theory: Theory;
  setup: Readonly<Setup>;
  /** Smallest gap under the highest point of the rim, in words. */
  gap: string;
  /** Time for most of the angle, in words. */
  time: string;
  /** The visitor's guess, rad. */
  guess: number;
}

export function factsOf(
  passage: Passage,
  theory: Theory,
  setup: Readonly<Setup>,
  guess: number,
): Facts {
  return {
    passage,
    theory,
    setup,
    gap: formatLengthShort(passage.validity.gap),
    time: formatDuration(passage.validity.passageTime),
    guess,
  };
}

/** Compares a guess with where the body came up, in whole degrees. */
export function cameUp({ passage, guess }: Facts): string {
  const degrees = (angle: number) => Math.round((angle * 180) / Math.PI);
  const [said, turned] = [degrees(guess), degrees(Math.abs(passage.angle))];
  const apart = Math.abs(turned - said);
  const { essay } = words;
  return sentences(
    say(essay.cameUp, { said: `${said}°`, straight: said === 180, turned: `${turned}°` }),
    apart <= 3
      ? essay.guessedWell
      : say(essay.guessedOff, { angle: `${apart}°`, further: turned > said }),
  );
}

/** Says how far the contact point ran and the body itself turned. */
export function ranRound({ passage, setup, gap, time }: Facts): string {
  const [angle, itself] = [passage.angle, passage.bodyAngle].map((angle) =>
    formatDegrees(Math.abs(angle), 1),
  ) as [string, string];
  return say(words.essay.ranRound, { angle, time, ...words.nouns[setup.body], itself, gap });
}

/** The guess as people read it. */
export function guessInWords(degrees: number): string {
  const aside = Math.abs(degrees - 180);
  return aside === 0
    ? say(words.essay.straight, { angle: `${degrees}°` })
    : say(words.essay.notStraight, {
        angle: `${degrees}°`,
        aside: `${aside}°`,
        beyond: degrees > 180,
      });
}

// Numbers in the prose of the essay. The page holds them as text, so that the prose is there before the core;
// the core then writes its own.

/** Every number of the prose by its name, as a text. */
export function numbersOf(core: Core): Record<string, string> {
  const setup: Setup = { ...INITIAL, ...SCENES[0]?.setup };
  const theoryOf = (part: Partial<Setup>) => {
    const all = { ...setup, ...part };
    return core.theory(bodyOf(core, all), startOf(all), contactLawOf(all), all.gravity);
  };
  const { body, start, contactLaw, options } = simulationInput(core, setup);
  const motion = core.simulate(body, start, contactLaw, options);
  const passage = passageFrom(motion, 0);
  motion.forget();
  if (!passage) throw new Error("the essay's can does not come down");
  const can = theoryOf({});
  const { time } = factsOf(passage, can, setup, 0);
  const flat = theoryOf({ body: "own", radius: 3, length: 0, wall: 0, base: 0, law: "no_slip" });
  const half = Math.abs(passage.angle) - Math.PI;
  return {
    aside: degrees(half, 0),
    time,
    limit: degrees(can.noSlip, 1),
    frictionless: degrees(can.frictionless, 1),
    needed: formatFixed(can.neededFriction, 2),
    disk: degrees(flat.noSlip, 1),
    "disk-beyond": degrees(flat.noSlip - 2 * Math.PI, 1),
    left: `${formatFixed(MEASURED.left.mean, 1)}°`,
    right: `${formatFixed(MEASURED.right.mean, 1)}°`,
  };
}

/** Writes the numbers into the elements that name them. */
export function writeNumbers(core: Core, place: HTMLElement): void {
  const numbers = numbersOf(core);
  for (const one of place.querySelectorAll<HTMLElement>("[data-number]"))
    one.textContent = numbers[one.dataset["number"] ?? ""] ?? "";
}

const degrees = (angle: number, decimals: number) =>
  `${formatFixed((angle * 180) / Math.PI, decimals)}°`;
