// The interface of the mechanics for the page, in SI units and radians. Results are the same as in
// Python to the last bit.

import { Computation } from "./computation";
import { Exchange, type Row } from "./exchange";
import { Motion } from "./motion";

export { Refused } from "./exchange";

/** An axisymmetric rigid body on the circular rim of its base. */
export interface Body {
  /** kg */
  mass: number;
  /** radius of the rim, m */
  radius: number;
  /** height of the centre of mass above the base, m */
  height: number;
  /** moment of inertia about a transverse axis through the centre of mass, kg m² */
  transverseInertia: number;
  /** moment of inertia about the body's axis, kg m² */
  axialInertia: number;
}

/** The paper's Euler angles (rad) and their rates (rad/s); the contact point is at azimuth yaw + π. */
export interface State {
  tilt: number;
  tiltRate: number;
  yaw: number;
  yawRate: number;
  spin: number;
  spinRate: number;
}

/** The laws of the core that the page offers. */
export type LawName = "no_slip" | "frictionless" | "coulomb";

/** Friction, restitution and resistance of the contact; omitted coefficients are zero. */
export interface ContactLaw {
  law: LawName;
  /** coefficient μ of dry friction */
  friction?: number;
  /** coefficient of restitution of a landing, 0 to 1 */
  restitution?: number;
  /** rolling resistance, N per N of normal force */
  rollingDry?: number;
}

export interface Options {
  /** s */
  duration: number;
  /** m/s² */
  gravity: number;
  rtol: number;
  maxSteps: number;
}

/** All that determines a motion on a table at rest. */
export interface Input {
  body: Body;
  start: State;
  contactLaw: ContactLaw;
  options: Options;
}

export type Preset =
  "can_2007" | "soda_can" | "beer_bottle" | "coin" | "ring" | "battery" | "euler_disk";

/** A solid that is a part of a body, in SI units; `base` is the height of its lower end. */
export interface Solid {
  shape: "disk" | "wall" | "cylinder";
  mass: number;
  radius: number;
  length: number;
  base: number;
}

/** The first turn of a release and its outcome. */
export interface Fall {
  /** An outcome as rimroll.ensemble names it. */
  outcome: string;
  /** Angle of turn, rad; NaN if the body did not come down within the duration. */
  turn: number;
  minTilt: number;
  /** s */
  time: number;
  endTilt: number;
  endYaw: number;
}

/** Closed forms, which need no computed motion; angles in rad. */
export interface Theory {
  noSlip: number;
  frictionless: number;
  /** The limiting turn on this table for a body that comes down from this start; NaN if it does not. */
  here: number;
  /** Needed friction μ*: the smallest one with which the body rolls through its near-collision. */
  neededFriction: number;
  painleveFriction: number;
  balanceTilt: number;
}

export class Core {
  /** Names in the order of the core, which refers to them by index. */
  private readonly names: Readonly<Record<"laws" | "outcomes" | "presets" | "shapes", string[]>>;

  protected constructor(protected readonly exchange: Exchange) {
    const { core } = exchange;
    const names = (list: () => void) => {
      list();
      return exchange.names();
    };
    this.names = {
      laws: names(core.laws),
      outcomes: names(core.outcomes),
      presets: names(core.presets),
      shapes: names(core.shapes),
    };
  }

  static async load(source: Response | BufferSource): Promise<Core> {
    return new Core(await Exchange.with(source));
  }

  /** A preset body; `argument` is the filled fraction, or the radius of a ring (m). */
  preset(name: Preset, argument = NaN): Body {
    this.exchange.put([argument]);
    this.exchange.checked(this.exchange.core.preset(this.names.presets.indexOf(name)));
    return this.body();
  }

  /** A body composed of solids on a rim with a radius (m). */
  composed(radius: number, solids: readonly Solid[]): Body {
    const numbers = solids.flatMap((s) => [
      this.names.shapes.indexOf(s.shape),
      s.mass,
      s.radius,
      s.length,
      s.base,
    ]);
    this.exchange.put([radius, ...numbers]);
    this.exchange.checked(this.exchange.core.composed());
    return this.body();
  }

  /** Computes a motion. Throws {@link Refused} for invalid input. */
  simulate(body: Body, start: State, contactLaw: ContactLaw, options: Options): Motion {
    return this.simulation(body, start, contactLaw, options).now();
  }

  /** The computation of a motion. */
  simulation(body: Body, start: State, contactLaw: ContactLaw, options: Options): Computation {
    const numbers = this.simulationNumbers(body, start, contactLaw, options);
    return new Computation(this.exchange, { name: "simulate", numbers });
  }

  protected simulationNumbers(
    body: Body,
    start: State,
    contactLaw: ContactLaw,
    options: Options,
  ): number[] {
    return [
      ...bodyNumbers(body),
      ...startNumbers(start),
      ...this.contactLawNumbers(contactLaw),
      ...optionNumbers(options),
    ];
  }

  /** Computes the first turn from each start; `frictionScale` multiplies the friction. */
  falls(
    body: Body,
    contactLaw: ContactLaw,
    options: Options,
    trials: readonly { start: State; frictionScale: number }[],
  ): Fall[] {
    this.exchange.put([
      ...bodyNumbers(body),
      ...this.contactLawNumbers(contactLaw),
      ...optionNumbers(options),
      ...trials.flatMap(({ start, frictionScale }) => [...startNumbers(start), frictionScale]),
    ]);
    this.exchange.checked(this.exchange.core.falls());
    const numbers = this.exchange.numbers();
    return trials.map((_, k) => {
      const [outcome, turn, minTilt, time, endTilt, endYaw] = numbers.subarray(
        6 * k,
        6 * k + 6,
      ) as unknown as Row<6>;
      return {
        outcome: this.names.outcomes[outcome] ?? "failed",
        turn,
        minTilt,
        time,
        endTilt,
        endYaw,
      };
    });
  }

  theory(body: Body, start: State, contactLaw: ContactLaw, gravity: number): Theory {
    this.exchange.put([
      ...bodyNumbers(body),
      ...startNumbers(start),
      ...this.contactLawNumbers(contactLaw),
      gravity,
    ]);
    this.exchange.checked(this.exchange.core.theory());
    const [noSlip, frictionless, here, neededFriction, painleveFriction, balanceTilt] =
      this.exchange.numbers() as unknown as Row<6>;
    return { noSlip, frictionless, here, neededFriction, painleveFriction, balanceTilt };
  }

  /** Omitted coefficients are passed as NaN. */
  private contactLawNumbers({ law, friction, restitution, rollingDry }: ContactLaw): number[] {
    const place = this.names.laws.indexOf(law);
    return [place, friction ?? NaN, restitution ?? NaN, rollingDry ?? NaN];
  }

  private body(): Body {
    const [mass, radius, height, transverseInertia, axialInertia] =
      this.exchange.numbers() as unknown as Row<5>;
    return { mass, radius, height, transverseInertia, axialInertia };
  }
}

const bodyNumbers = (b: Body) => [b.mass, b.radius, b.height, b.transverseInertia, b.axialInertia];

const startNumbers = (s: State) => [s.tilt, s.tiltRate, s.yaw, s.yawRate, s.spin, s.spinRate];

const optionNumbers = (o: Options) => [o.duration, o.gravity, o.rtol, o.maxSteps];
