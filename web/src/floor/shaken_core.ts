// The core with tables that move. It is a file of its own, because most visitors do not shake the floor.

import { Core, type Body, type ContactLaw, type Options, type State } from "../core/core";
import { Computation } from "../core/computation";
import { Exchange } from "../core/exchange";
import type { TableMotion } from "./shaking";

type Vector = readonly [x: number, y: number, z: number];

/** An amplitude (m/s²) times a function of time with the largest value 1; times in s. */
export interface Pulse {
  shape: "constant" | "sine" | "cosine" | "ricker";
  amplitude: Vector;
  period: number;
  duration: number;
  center: number;
}

/** Samples of the acceleration, m/s², at equal intervals (s). */
export interface AccelerationRecord {
  step: number;
  samples: readonly Vector[];
}

export type Ground = Pulse | AccelerationRecord;

interface ShakenExports {
  pulse_shapes(): void;
  flat_landings(): void;
  table_motion(): number;
}

export class ShakenCore extends Core {
  private readonly shakes: ShakenExports;
  private readonly pulseShapes: string[];
  private readonly flatLandings: string[];

  protected constructor(exchange: Exchange) {
    super(exchange);
    this.shakes = exchange.core as unknown as ShakenExports;
    this.shakes.pulse_shapes();
    this.pulseShapes = exchange.names();
    this.shakes.flat_landings();
    this.flatLandings = exchange.names();
  }

  static override async load(source: Response | BufferSource): Promise<ShakenCore> {
    return new ShakenCore(await Exchange.with(source));
  }

  /** The computation of a motion on a table that moves. */
  simulationOn(
    ground: Ground,
    flat: string,
    body: Body,
    start: State,
    contactLaw: ContactLaw,
    options: Options,
  ): Computation {
    const numbers = [
      ...this.simulationNumbers(body, start, contactLaw, options),
      this.flatLandings.indexOf(flat),
      ...this.groundNumbers(ground),
    ];
    return new Computation(this.exchange, { name: "simulate_shaken", numbers });
  }

  /** The motion of the table at times, s. */
  tableMotion(ground: Ground, times: ArrayLike<number>): TableMotion {
    this.exchange.put([...this.groundNumbers(ground), ...Array.from(times)]);
    this.exchange.checked(this.shakes.table_motion());
    const numbers = this.exchange.numbers();
    const column = (place: number) =>
      Float64Array.from({ length: times.length }, (_, k) => numbers[6 * k + place] as number);
    return {
      ground_acceleration_x: column(0),
      ground_acceleration_y: column(1),
      ground_acceleration_z: column(2),
      ground_displacement_x: column(3),
      ground_displacement_y: column(4),
      ground_displacement_z: column(5),
    };
  }

  private groundNumbers(ground: Ground): number[] {
    if ("samples" in ground)
      return [0, ground.step, ground.samples.length, ...ground.samples.flat()];
    const { shape, amplitude, period, duration, center } = ground;
    return [1, this.pulseShapes.indexOf(shape), ...amplitude, period, duration, center];
  }
}
