// What is plotted: five figures of a few lines each.

import type { LawName, Theory } from "../core/core";
import type { Column, Moment, Moments, Motion } from "../core/motion";
import type { Colour } from "./palette";
import { countBelow } from "./sampled";
import type { Values } from "./thinned";

/** All that a figure is drawn from. */
export interface Subject {
  motion: Motion;
  theory: Theory | undefined;
  law: LawName;
  friction: number;
  /** The least potential energy of the motion, J; energies are counted from it. */
  ground: number;
}

export interface Line {
  label: string;
  colour: Colour;
  dash?: number[];
  /** CSS px; 2 if not given. */
  width?: number;
  /** Along the moments, in the figure's unit; null where there is nothing to draw. */
  values(moments: Moments, subject: Subject): Values;
  /** At the moment shown; without it the line is in the key, but not read out. */
  now?(moment: Moment, subject: Subject): number;
}

export interface Figure {
  name: string;
  title: string;
  unit: string;
  lines: readonly Line[];
  /** Whether lines are the borders of areas one upon the other. */
  stacked?: boolean;
  /** Whether small values are drawn larger beside large ones. */
  stretched?: boolean;
  /** What is always in view. */
  include?: number;
  /** Whether the unit gets the prefix that suits the values, as milli. */
  prefixed?: boolean;
}

const DEGREES = 180 / Math.PI;

export const FIGURES: readonly Figure[] = [
  {
    name: "tilt",
    title: "Tilt",
    unit: "°",
    include: 0,
    lines: [plain("tilt", "tilt", "plot-first", DEGREES)],
  },
  {
    name: "yaw",
    title: "Yaw",
    unit: "°",
    lines: [
      plain("direction of the lean", "yaw", "plot-first", DEGREES),
      { label: "theory, first turn", colour: "theory", dash: [6, 4], values: turnedInTheory },
    ],
  },
  {
    name: "rates",
    title: "Rates",
    unit: "rad/s",
    stretched: true,
    lines: [
      plain("tilt", "tilt_rate", "plot-second"),
      plain("yaw", "yaw_rate", "plot-first"),
      { ...plain("spin", "spin_rate", "plot-third"), dash: [7, 3] },
    ],
  },
  {
    name: "friction",
    title: "Friction ratio",
    unit: "",
    include: 0,
    lines: [
      {
        label: "available μ",
        colour: "warn",
        width: 5,
        values: (moments, { law, friction }) =>
          constant(moments, law === "coulomb" ? friction : NaN),
        now: (_, { law, friction }) => (law === "coulomb" ? friction : NaN),
      },
      plain("used |T|/N", "friction_ratio", "plot-first"),
      {
        label: "needed to roll μ*",
        colour: "theory",
        dash: [6, 4],
        values: (moments, { theory }) => constant(moments, theory?.neededFriction ?? NaN),
        now: (_, { theory }) => theory?.neededFriction ?? NaN,
      },
    ],
  },
  {
    name: "energy",
    title: "Energy",
    unit: "J",
    include: 0,
    stacked: true,
    prefixed: true,
    lines: [
      {
        ...plain("height", "potential_energy", "plot-first"),
        values: (moments, { ground }) =>
          moments.column("potential_energy").map((energy) => energy - ground),
        now: (moment, { ground }) => moment.potential_energy - ground,
      },
      plain("motion", "kinetic_energy", "plot-second"),
      plain("lost sliding", "friction_loss", "plot-third"),
      plain("lost rolling", "resistance_loss", "plot-fourth"),
      plain("lost in impacts", "impact_loss", "plot-fifth"),
    ],
  },
];

/** A column as it is, but for the unit. */
function plain(label: string, column: Column, colour: Colour, factor = 1): Line {
  return {
    label,
    colour,
    values: (moments) => finite(moments.column(column), factor),
    now: (moment) => factor * moment[column],
  };
}

/** Where nothing presses the ratio of friction is infinite: a gap. */
function finite(column: Float64Array, factor: number): Values {
  // A sum is finite just if all of its terms are, these being nowhere near the largest number.
  let sum = 0;
  for (let k = 0; k < column.length; k++) sum += column[k] as number;
  if (Number.isFinite(sum)) return factor === 1 ? column : scaled(column, factor);
  return Array.from(column, (value) => (Number.isFinite(value) ? factor * value : null));
}

function scaled(column: Float64Array, factor: number): Float64Array {
  const values = column.slice();
  for (let k = 0; k < values.length; k++) values[k] = factor * (values[k] as number);
  return values;
}

const constant = ({ length }: Moments, value: number): Values =>
  new Array<number | null>(length).fill(Number.isFinite(value) ? value : null);

/** The yaw to which the theory has the first turn come, along that turn. */
function turnedInTheory(moments: Moments, { motion, theory }: Subject): Values {
  const values = constant(moments, NaN) as (number | null)[];
  const [turn] = motion.turns;
  if (!turn || !theory || Number.isNaN(theory.here)) return values;
  const yaw = motion.at([turn.start]).moment(0).yaw + Math.sign(turn.angle) * theory.here;
  const times = moments.column("t");
  return values.fill(yaw * DEGREES, countBelow(times, turn.t), countBelow(times, turn.end));
}
