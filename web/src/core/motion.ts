// A computed motion. It is stored in the core and evaluated on request.

import type { Exchange, Row } from "./exchange";

/** Quantities of a moment, in SI units and radians, as listed in rimroll.motion.UNITS. */
export type Column =
  | "t"
  | "tilt"
  | "tilt_rate"
  | "yaw"
  | "yaw_rate"
  | "spin"
  | "spin_rate"
  | "axial_spin"
  | "x"
  | "y"
  | "z"
  | "contact_x"
  | "contact_y"
  | "normal_force"
  | "friction_x"
  | "friction_y"
  | "friction_ratio"
  | "slip_x"
  | "slip_y"
  | "gap"
  | "kinetic_energy"
  | "potential_energy"
  | "friction_loss"
  | "resistance_loss"
  | "impact_loss"
  | "ground_work";

/** The state of the motion at one time. */
export type Moment = Record<Column, number>;

/** Heading of the body, rad: the azimuth of a mark on it after tipping it upright, straight back from its
 * lean. Only a rotation about the body's axis changes it; a change of the lean does not. */
export const headingOf = ({ yaw, spin }: Pick<Moment, "yaw" | "spin">): number => yaw + spin;

/** Many moments, stored by columns. */
export class Moments {
  readonly length: number;

  constructor(
    readonly names: readonly Column[],
    /** All numbers of one column, then those of the next. */
    readonly numbers: Float64Array,
  ) {
    this.length = numbers.length / names.length;
  }

  column(name: Column): Float64Array {
    const first = this.names.indexOf(name) * this.length;
    return this.numbers.subarray(first, first + this.length);
  }

  moment(index: number): Moment {
    const entries = this.names.map((name, k) => [name, this.numbers[k * this.length + index]]);
    return Object.fromEntries(entries) as Moment;
  }
}

/** An event: `tilt_min`, `tilt_max`, `slip`, `stick`, `lift_off`, `land`, `topple`, … */
export interface Event {
  kind: string;
  moment: Moment;
}

/** A phase of a motion between two times (s): `rolling`, `sliding`, `flying`, `lying` or, on a floor that moves,
 * `standing`, `sliding_flat` or `flying_level`. */
export interface Phase {
  kind: string;
  start: number;
  end: number;
}

/** A turn, from the release or a tilt maximum to the next maximum, in rad and s. */
export interface Turn {
  angle: number;
  minTilt: number;
  /** Time of the smallest tilt. */
  t: number;
  /** Yaw rate at that time, rad/s. */
  yawRate: number;
  start: number;
  end: number;
  maxTilt: number;
}

/** How far the model holds for a part of a motion; as rimroll.Validity in Python. */
export interface Validity {
  /** Height of the highest point of the rim above its lowest at the smallest tilt, m. */
  gap: number;
  /** Speed of the contact point along the rim then, m/s. */
  contactSpeed: number;
  /** Time from a tenth to nine tenths of the angle, s. */
  passageTime: number;
  /** Time in which sound crosses the base, s. */
  soundTime: number;
  /** Largest normal force over the weight. */
  forceRatio: number;
  /** Energy lost over the largest kinetic energy. */
  lossRatio: number;
  /** Which of these are beyond the model. */
  exceeded: Record<"gap" | "contactSpeed" | "passageTime" | "lossRatio", boolean>;
  /** How far rims and tables depart from a plane, from fine to coarse, m. */
  unevenness: readonly [number, number];
  /** Speed of sound in the body, m/s. */
  speedOfSound: number;
}

/** Largest number of points that are useful in a picture. */
const MAX_POINTS = 4000;
/** A step divided into this many parts makes a line without visible corners. */
const MAX_PARTS = 4;

/** What a worker has computed of a motion: the numbers of the samples at its steps, and the yaws. */
export interface Known {
  steps: Float64Array;
  yaws: Yaws;
}

export class Motion {
  readonly status: string;
  readonly message: string;
  readonly events: readonly Event[];
  readonly phases: readonly Phase[];
  readonly turns: readonly Turn[];
  /** End of the motion, s. */
  readonly end: number;
  private readonly names: readonly Column[];
  /** The latest samples, which several parts of the page use. */
  private sampled: { perStep: number; moments: Moments } | undefined;
  private curvePoints: Moments | undefined;
  private yawPoints: Yaws | undefined;

  constructor(
    private readonly exchange: Exchange,
    private address: number,
    known?: Known,
  ) {
    const { core } = exchange;
    core.columns();
    this.names = exchange.names() as Column[];
    if (known) {
      this.sampled = { perStep: 1, moments: new Moments(this.names, known.steps) };
      this.yawPoints = known.yaws;
    }
    core.status(address);
    this.status = exchange.text();
    core.message(address);
    this.message = exchange.text();
    this.end = this.at([Infinity]).moment(0).t;
    core.events(address);
    const moments = this.table();
    this.events = exchange.names().map((kind, k) => ({ kind, moment: moments.moment(k) }));
    core.phases(address);
    const starts = exchange.numbers();
    this.phases = exchange.names().map((kind, k) => ({
      kind,
      start: starts[k] as number,
      end: starts[k + 1] ?? this.end,
    }));
    core.turns(address);
    this.turns = rows(exchange.numbers(), 7).map((row) => {
      const [angle, minTilt, t, yawRate, start, end, maxTilt] = row as Row<7>;
      return { angle, minTilt, t, yawRate, start, end, maxTilt };
    });
  }

  /** The motion at any times (s); times outside the motion give its ends. */
  at(times: ArrayLike<number>): Moments {
    this.exchange.put(times);
    this.exchange.core.at(this.validAddress());
    return this.table();
  }

  /** Moments at the end of each solver step and inside it: dense where the motion is fast. */
  samples(perStep: number): Moments {
    if (this.sampled?.perStep !== perStep)
      this.sampled = { perStep, moments: this.sample(perStep) };
    return this.sampled.moments;
  }

  private sample(perStep: number): Moments {
    this.exchange.core.samples(this.validAddress(), perStep);
    return this.table();
  }

  /** The yaw at the solver steps and between them. */
  yaws(): Yaws {
    return (this.yawPoints ??= yawsOf(this.samples(1)));
  }

  /** How far the model holds from `start` to `end` with the smallest tilt at `lowest`, s. */
  validity(start: number, lowest: number, end: number): Validity {
    this.exchange.core.validity(this.validAddress(), start, lowest, end);
    const [
      gap,
      contactSpeed,
      passageTime,
      soundTime,
      forceRatio,
      lossRatio,
      isUneven,
      isFast,
      isFlexible,
      isLossless,
      fine,
      coarse,
      speedOfSound,
    ] = Array.from(this.exchange.numbers()) as Row<13>;
    return {
      gap,
      contactSpeed,
      passageTime,
      soundTime,
      forceRatio,
      lossRatio,
      exceeded: {
        gap: isUneven === 1,
        contactSpeed: isFast === 1,
        passageTime: isFlexible === 1,
        lossRatio: isLossless === 1,
      },
      unevenness: [fine, coarse],
      speedOfSound,
    };
  }

  /** Moments to draw lines through: at the solver steps and, if these are few, between them. */
  curve(): Moments {
    return (this.curvePoints ??= this.sampleCurve());
  }

  private sampleCurve(): Moments {
    const steps = this.samples(1);
    const parts = Math.min(Math.floor(MAX_POINTS / steps.length), MAX_PARTS);
    return parts < 2 ? steps : this.sample(parts);
  }

  /** Frees the core's memory; the motion cannot be evaluated afterwards. */
  forget(): void {
    this.exchange.core.forget(this.validAddress());
    this.address = 0;
    this.sampled = this.curvePoints = this.yawPoints = undefined;
  }

  /** Whether the motion ended because it reached the limit of steps. */
  get ranOutOfSteps(): boolean {
    return this.status === "failed" && this.message.includes("max_steps");
  }

  private validAddress(): number {
    if (this.address === 0) throw new Error("this motion was forgotten");
    return this.address;
  }

  private table(): Moments {
    return new Moments(this.names, this.exchange.numbers());
  }
}

const rows = (numbers: Float64Array, length: number): number[][] =>
  Array.from({ length: numbers.length / length }, (_, k) =>
    Array.from(numbers.subarray(k * length, (k + 1) * length)),
  );

// The yaw at the solver steps and between them.

/** Times (s) and yaws (rad). */
export interface Yaws {
  t: Float64Array;
  yaw: Float64Array;
}

/** Each solver step is divided into this many parts, so that the yaw rate hardly changes in one. */
const PARTS = 4;

/** Yaws at the solver steps and between them, by cubic Hermite interpolation. To request as many moments from the core takes a
 * hundred times as long. */
export function yawsOf(steps: Moments): Yaws {
  const [times, yaws, rates] = [steps.column("t"), steps.column("yaw"), steps.column("yaw_rate")];
  const length = PARTS * (times.length - 1) + 1;
  const [t, yaw] = [new Float64Array(length), new Float64Array(length)];
  t[0] = at(times, 0);
  yaw[0] = at(yaws, 0);
  for (let k = 1, n = 1; k < times.length; k++) {
    const [from, to] = [at(times, k - 1), at(times, k)];
    const [start, rise] = [at(yaws, k - 1), at(yaws, k) - at(yaws, k - 1)];
    const [first, last] = [at(rates, k - 1) * (to - from), at(rates, k) * (to - from)];
    for (let part = 1; part < PARTS; part++, n++) {
      const s = part / PARTS;
      t[n] = from + s * (to - from);
      yaw[n] =
        start + s * (first + s * (3 * rise - 2 * first - last + s * (first + last - 2 * rise)));
    }
    t[n] = to;
    yaw[n++] = at(yaws, k);
  }
  return { t, yaw };
}

const at = (array: Float64Array, index: number) => array[index] as number;

// The collisions and near-collisions of a motion.

export interface Collision {
  /** s */
  t: number;
  /** Approximate duration, s: the time of half a revolution at the yaw rate of its middle. */
  duration: number;
}

// Events at which the base comes near the table or meets it.
const COLLISIONS = new Set(["tilt_min", "land", "face_down", "topple"]);

/** The collisions in the order of time. */
export function collisionsOf(motion: Motion): Collision[] {
  return motion.events
    .filter((event) => COLLISIONS.has(event.kind))
    .map(({ moment: { t, yaw_rate } }) => ({
      t,
      duration: Math.min(Math.PI / Math.abs(yaw_rate), motion.end / 10),
    }));
}

/** Index of the collision nearest to a time (s), or -1 if there is none. */
export function nearest(collisions: readonly Collision[], time: number): number {
  const distance = (index: number) => Math.abs((collisions[index]?.t ?? Infinity) - time);
  let best = collisions.length - 1;
  for (let k = best; k-- > 0;) if (distance(k) <= distance(best)) best = k;
  return best;
}

// Searches in increasing numbers.

/** How many of increasing numbers are below a bound. */
export function countBelow(rising: ArrayLike<number>, bound: number): number {
  let [low, high] = [0, rising.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((rising[middle] as number) < bound) low = middle + 1;
    else high = middle;
  }
  return low;
}
