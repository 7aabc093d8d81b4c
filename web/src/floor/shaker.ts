// Shakes the floor: simulates on it, and tells where the table is.

import type { State } from "../core/core";
import type { Computation } from "../core/computation";
import type { Motion } from "../core/motion";
import type { Setup } from "../setup/setup";
import type { SimulationInput } from "../setup/simulation_input";
import { digits } from "../setup/digits";
import { follower } from "./follower";
import { pulseCode, pulseOf } from "./pulse";
import { recordCode, recordFrom } from "./record";
import type { Ground, ShakenCore } from "./shaken_core";
import type { InPicture, Shaker, Shaking, TableMotion } from "./shaking";
import { shakenVerdict } from "./words";

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

  simulation({ body, start, contactLaw, options }: SimulationInput): Computation {
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
