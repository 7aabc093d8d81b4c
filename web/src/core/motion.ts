// A computed motion. It stays in the core; here it is looked up.

import type { Exchange, Row } from "./exchange";

/** What is known at a moment, in SI units and radians, as rimroll.motion.UNITS lists it. */
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
  | "impact_loss";

/** One moment. */
export type Moment = Record<Column, number>;

/** Where a mark on the body points, rad: its azimuth once the body is tipped upright, straight back from
 * its lean. Only a turn of the body about its axis changes it; to lean elsewhere does not. */
export const headingOf = ({ yaw, spin }: Pick<Moment, "yaw" | "spin">): number => yaw + spin;

/** Many moments, column by column. */
export class Moments {
  readonly length: number;

  constructor(
    readonly names: readonly Column[],
    private readonly numbers: Float64Array,
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

/** Something that happened: `tilt_min`, `tilt_max`, `slip`, `stick`, `lift_off`, `land`, `topple`, … */
export interface Event {
  kind: string;
  moment: Moment;
}

/** A stretch of a motion: `rolling`, `sliding`, `flying` or `lying`, from a time (s) on. */
export interface Phase {
  kind: string;
  start: number;
  end: number;
}

/** From the release or a tilt maximum through a tilt minimum to the next maximum; rad and s. */
export interface Turn {
  angle: number;
  minTilt: number;
  /** Time of the smallest tilt. */
  t: number;
  /** Yaw rate then, rad/s. */
  yawRate: number;
  start: number;
  end: number;
  maxTilt: number;
}

/** More points than this no picture shows. */
const MANY = 4000;
/** In a part of a step as small as this no body turns by more than a line may have corners. */
const PARTS = 4;

export class Motion {
  readonly status: string;
  readonly message: string;
  readonly events: readonly Event[];
  readonly phases: readonly Phase[];
  readonly turns: readonly Turn[];
  /** When it ends, s. */
  readonly end: number;
  private readonly names: readonly Column[];
  /** The samples asked for last: several parts of the page look at the same ones. */
  private sampled: { perStep: number; moments: Moments } | undefined;
  private curvePoints: Moments | undefined;

  constructor(
    private readonly exchange: Exchange,
    private address: number,
  ) {
    const { core } = exchange;
    core.columns();
    this.names = exchange.names() as Column[];
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

  /** The motion at any times, s; times outside it give its ends. */
  at(times: ArrayLike<number>): Moments {
    this.exchange.put(times);
    this.exchange.core.at(this.validAddress());
    return this.table();
  }

  /** Moments inside each step of the solver and at its end: close together just where it is fast. */
  samples(perStep: number): Moments {
    if (this.sampled?.perStep !== perStep)
      this.sampled = { perStep, moments: this.sample(perStep) };
    return this.sampled.moments;
  }

  private sample(perStep: number): Moments {
    this.exchange.core.samples(this.validAddress(), perStep);
    return this.table();
  }

  /** Moments to draw lines through: at the solver's steps, and where these are few, between them. */
  curve(): Moments {
    return (this.curvePoints ??= this.sampleCurve());
  }

  private sampleCurve(): Moments {
    const steps = this.samples(1);
    const parts = Math.min(Math.floor(MANY / steps.length), PARTS);
    return parts < 2 ? steps : this.sample(parts);
  }

  /** Gives the core's memory back; the motion cannot be looked up afterwards. */
  forget(): void {
    this.exchange.core.forget(this.validAddress());
    this.address = 0;
    this.sampled = this.curvePoints = undefined;
  }

  /** Whether it ends where it does because no more steps were allowed. */
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
