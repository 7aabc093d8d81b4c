// The part of the page that is loaded when a visitor first shakes the floor: it simulates on it, and tells where the table is.

import type { Displacement, InPicture, Shaker, Shaking, TableMotion } from "./shaking";
import {
  type Body,
  type ContactLaw,
  Core,
  type Input,
  type Options,
  type State,
} from "../core/core";
import { Computation } from "../core/computation";
import type { Motion } from "../core/motion";
import type { Setup } from "../setup/setup";
import { digits } from "../setup/export";
import { type Ground, pulseCode, pulseOf, recordCode, recordFrom } from "./ground";
import { shakenVerdict } from "./verdict";
import { Exchange } from "../core/exchange";

export { mountFloorControls } from "./controls";

let shaker: Promise<Shaker> | undefined;

/** Loads the core with tables that move; a second call gives the same one. */
export function loadShaker(): Promise<Shaker> {
  return (shaker ??= loadCore().then(shakerWith));
}

/** The page that rimroll.lab makes carries this core in place of the other. */
const loadCore = async (): Promise<ShakenCore> =>
  ShakenCore.load(
    import.meta.env.MODE === "alone"
      ? (globalThis as unknown as { rimrollCore: ArrayBuffer }).rimrollCore
      : await fetch(new URL("../core/rimroll-ground.wasm", import.meta.url)),
  );

// Shakes the floor: simulates on it, and tells where the table is.

export function shakerWith(core: ShakenCore): Shaker {
  return {
    inputOf(setup, atRest) {
      const { yaw } = atRest.start;
      const standing = { tilt: 0, tiltRate: 0, yaw, yawRate: 0, spin: 0, spinRate: 0 };
      const start = setup.start === "standing" ? standing : atRest.start;
      const shaking = new GroundShaking(core, setup, start, atRest.options.duration);
      return { ...atRest, start, shaking };
    },
  };
}

class GroundShaking implements Shaking {
  private readonly ground: Ground;
  private followed: { leash: number; at: (time: number) => InPicture } | undefined;
  readonly python: Shaking["python"];

  constructor(
    private readonly core: ShakenCore,
    private readonly setup: Readonly<Setup>,
    { yaw }: State,
    private readonly duration: number,
  ) {
    const record = setup.floor === "hand" ? recordFrom(setup.record) : undefined;
    this.ground = record ?? pulseOf(setup);
    this.python = {
      start: setup.start === "standing" ? `rr.State.standing(yaw=${digits(yaw)})` : undefined,
      ground: record ? recordCode(record) : pulseCode(setup),
      flat: setup.flat,
    };
  }

  simulation({ body, start, contactLaw, options }: Input): Computation {
    const { core, ground, setup } = this;
    return core.simulationOn(ground, setup.flat, body, start, contactLaw, options);
  }

  at(times: ArrayLike<number>): TableMotion {
    return this.core.tableMotion(this.ground, times);
  }

  inPicture(time: number, leash: number): InPicture {
    if (this.followed?.leash !== leash)
      this.followed = {
        leash,
        at: follower((times) => this.at(times), this.duration, leash),
      };
    return this.followed.at(time);
  }

  verdict(motion: Motion, balanceTilt: number): ReturnType<Shaking["verdict"]> {
    return shakenVerdict(motion, this, balanceTilt, this.setup);
  }
}

// A camera that follows a table that moves away. Until then it stands still, and the table moves in the picture.

/** Places of the table that are computed at once. */
const PLACES = 2000;

/** Where table and camera are at a time (s) of a motion with a duration (s). The camera is drawn along when the
 * table is farther than `leash` (m) from the middle. */
export function follower(
  tableAt: (times: ArrayLike<number>) => TableMotion,
  duration: number,
  leash: number,
): (time: number) => InPicture {
  const step = duration / PLACES;
  const times = Float64Array.from({ length: PLACES + 1 }, (_, k) => k * step);
  const table = tableAt(times);
  const [x, y, z] = [
    table.ground_displacement_x,
    table.ground_displacement_y,
    table.ground_displacement_z,
  ];
  const camera = { x: 0, y: 0, z: 0 };
  const places = Array.from(times, (_, k): InPicture => {
    const [dx, dy, dz] = [x[k], y[k], z[k]] as [number, number, number];
    const [ax, ay, az] = [dx - camera.x, dy - camera.y, dz - camera.z];
    const part = Math.max(1 - leash / Math.hypot(ax, ay, az), 0);
    camera.x += part * ax;
    camera.y += part * ay;
    camera.z += part * az;
    const inside = { x: dx - camera.x, y: dy - camera.y, z: dz - camera.z };
    return { table: inside, camera: { ...camera } };
  });
  return (time) => {
    const place = Math.min(Math.max(time / step, 0), PLACES);
    const low = Math.min(Math.floor(place), PLACES - 1);
    const [from, to] = [places[low] as InPicture, places[low + 1] as InPicture];
    const of = (what: keyof InPicture): Displacement => {
      const between = (axis: keyof Displacement) =>
        from[what][axis] + (place - low) * (to[what][axis] - from[what][axis]);
      return { x: between("x"), y: between("y"), z: between("z") };
    };
    return { table: of("table"), camera: of("camera") };
  };
}

// The core with tables that move.

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
