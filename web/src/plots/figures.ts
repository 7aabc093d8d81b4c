// The figures and their lines.

import type { LawName, Theory } from "../core/core";
import { type Column, countBelow, type Moment, type Moments, type Motion } from "../core/motion";
import type { Shaking, TableMotion } from "../floor/shaking";
import { bodyRates, bodyRatesAt, type Rates } from "../gyro/rates";
import type { Colour } from "./palette";
import type { Values } from "./samples";
import { say, words } from "../words/words";

/** The data of a figure. */
export interface Subject {
  motion: Motion;
  theory: Theory | undefined;
  law: LawName;
  friction: number;
  /** How the floor moves, if it moves. */
  shaking: Shaking | undefined;
  /** Smallest potential energy of the motion, J, from which energies are counted. */
  ground: number;
}

export interface Line {
  label: string;
  colour: Colour;
  dash?: number[];
  /** Width, CSS px; 2 by default. */
  width?: number;
  /** Values at the moments, in the figure's unit; null where there is nothing to draw. */
  values(moments: Moments, subject: Subject): Values;
  /** Value at the moment shown; without this function the key shows the line without a value. */
  now?(moment: Moment, subject: Subject): number;
}

export interface Figure {
  name: string;
  title: string;
  /** Name where there is little room. */
  short: string;
  unit: string;
  lines: readonly Line[];
  /** The line of a second motion that is compared. */
  other?: Line;
  /** Whether the lines are borders of stacked areas. */
  stacked?: boolean;
  /** Whether the axis is an arsinh, which enlarges small values. */
  stretched?: boolean;
  /** A value that is always in view. */
  include?: number;
  /** Whether the unit gets a suitable prefix, such as milli. */
  prefixed?: boolean;
}

const DEGREES = 180 / Math.PI;
/** Dashes of a second motion, CSS px. */
const DASHED = [4, 3];

/** The figure of a floor that moves. */
export const FLOOR = "floor";

const { figures } = words.plots;

export const FIGURES: readonly Figure[] = [
  {
    name: FLOOR,
    title: figures.floor.title,
    short: figures.floor.short,
    unit: "m/s²",
    include: 0,
    lines: [
      ofFloor(figures.floor.x, "ground_acceleration_x", "plot-first"),
      { ...ofFloor(figures.floor.y, "ground_acceleration_y", "plot-second"), dash: [7, 3] },
      { ...ofFloor(figures.floor.z, "ground_acceleration_z", "plot-third"), dash: [2, 3] },
    ],
  },
  {
    name: "tilt",
    title: figures.tilt.title,
    short: figures.tilt.short,
    unit: "°",
    include: 0,
    lines: [plain(figures.tilt.tilt, "tilt", "plot-first", DEGREES)],
    other: ofOther(plain(figures.tilt.tilt, "tilt", "ghost", DEGREES)),
  },
  {
    name: "yaw",
    title: figures.yaw.title,
    short: figures.yaw.short,
    unit: "°",
    lines: [
      plain(figures.yaw.yaw, "yaw", "plot-first", DEGREES),
      { label: figures.yaw.theory, colour: "theory", dash: [6, 4], values: turnedInTheory },
    ],
    other: ofOther(plain(figures.yaw.yaw, "yaw", "ghost", DEGREES)),
  },
  {
    name: "rates",
    title: figures.rates.title,
    short: figures.rates.short,
    unit: "rad/s",
    stretched: true,
    lines: [
      plain(figures.rates.tilt, "tilt_rate", "plot-second"),
      plain(figures.rates.yaw, "yaw_rate", "plot-first"),
      { ...plain(figures.rates.spin, "spin_rate", "plot-third"), dash: [7, 3] },
    ],
    other: ofOther(plain(figures.rates.yaw, "yaw_rate", "ghost")),
  },
  {
    name: "gyroscope",
    title: figures.gyroscope.title,
    short: figures.gyroscope.short,
    unit: "rad/s",
    lines: [
      ofGyroscope("x", figures.gyroscope.x, "plot-first"),
      { ...ofGyroscope("y", figures.gyroscope.y, "plot-second"), dash: [7, 3] },
      { ...ofGyroscope("z", figures.gyroscope.z, "plot-third"), dash: [2, 3] },
    ],
  },
  {
    name: "friction",
    title: figures.friction.title,
    short: figures.friction.short,
    unit: "",
    include: 0,
    lines: [
      {
        label: figures.friction.available,
        colour: "warn",
        width: 5,
        values: (moments, { law, friction }) =>
          constant(moments, law === "coulomb" ? friction : NaN),
        now: (_, { law, friction }) => (law === "coulomb" ? friction : NaN),
      },
      plain(figures.friction.used, "friction_ratio", "plot-first"),
      {
        label: figures.friction.needed,
        colour: "theory",
        dash: [6, 4],
        values: (moments, { theory }) => constant(moments, theory?.neededFriction ?? NaN),
        now: (_, { theory }) => theory?.neededFriction ?? NaN,
      },
    ],
    other: ofOther(plain(figures.friction.used, "friction_ratio", "ghost")),
  },
  {
    name: "energy",
    title: figures.energy.title,
    short: figures.energy.short,
    unit: "J",
    include: 0,
    stacked: true,
    prefixed: true,
    lines: [
      {
        ...plain(figures.energy.potential, "potential_energy", "plot-first"),
        values: (moments, { ground }) =>
          moments.column("potential_energy").map((energy) => energy - ground),
        now: (moment, { ground }) => moment.potential_energy - ground,
      },
      plain(figures.energy.kinetic, "kinetic_energy", "plot-second"),
      plain(figures.energy.sliding, "friction_loss", "plot-third"),
      plain(figures.energy.rolling, "resistance_loss", "plot-fourth"),
      plain(figures.energy.impacts, "impact_loss", "plot-fifth"),
    ],
    other: {
      label: words.compare.total,
      colour: "ghost",
      dash: DASHED,
      values: (moments, { ground }) => {
        const kinetic = moments.column("kinetic_energy");
        const potential = moments.column("potential_energy");
        return finite(
          potential.map((energy, k) => energy - ground + kinetic[k]!),
          1,
        );
      },
      now: (moment, { ground }) => moment.kinetic_energy + moment.potential_energy - ground,
    },
  },
];

/** The line of a second motion. */
function ofOther(line: Line): Line {
  return { ...line, label: say(words.compare.plot, { label: line.label }), dash: DASHED };
}

/** A column in another unit. */
function plain(label: string, column: Column, colour: Colour, factor = 1): Line {
  return {
    label,
    colour,
    values: (moments) => finite(moments.column(column), factor),
    now: (moment) => factor * moment[column],
  };
}

/** A rate that a gyroscope in the body shows. */
function ofGyroscope(axis: keyof Rates, label: string, colour: Colour): Line {
  return {
    label,
    colour,
    values: (moments) => finite(bodyRates(moments)[axis]),
    now: (moment) => bodyRatesAt(moment)[axis],
  };
}

/** A component of the motion of the table; nothing is drawn if it is zero throughout. */
function ofFloor(label: string, column: keyof TableMotion, colour: Colour): Line {
  return {
    label,
    colour,
    values: (moments, { shaking }) => {
      const values = shaking?.at(moments.column("t"))[column];
      return values?.some((value) => value !== 0) ? values : constant(moments, NaN);
    },
    now: ({ t }, { shaking }) => shaking?.at([t])[column][0] ?? NaN,
  };
}

/** Infinite values become gaps: the friction ratio is infinite where the normal force is zero. So do those
 * after the end of the shorter of two motions, which are NaN. */
export function finite(column: Float64Array, factor = 1): Values {
  // The sum is finite if and only if all terms are, because they are far below the largest number.
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

/** The yaw at the end of the first turn in theory, drawn from its smallest tilt to its end. */
function turnedInTheory(moments: Moments, { motion, theory }: Subject): Values {
  const values = constant(moments, NaN) as (number | null)[];
  const [turn] = motion.turns;
  if (!turn || !theory || Number.isNaN(theory.here)) return values;
  const yaw = motion.at([turn.start]).moment(0).yaw + Math.sign(turn.angle) * theory.here;
  const times = moments.column("t");
  return values.fill(yaw * DEGREES, countBelow(times, turn.t), countBelow(times, turn.end));
}
