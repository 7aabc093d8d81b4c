// Repeats a release with the scatter of a human hand and computes where the body falls.

import type { Core } from "../core/core";
import { reasonOrRethrow } from "../core/reason";
import { simulationInput } from "../setup/simulation_input";
import type { Setup } from "../setup/setup";
import { scatteredStarts } from "./scatter";

/** The result of one flick. */
export interface Flick {
  /** An outcome as rimroll.ensemble names it: `toppled`, `rocked` (up again) or another. */
  outcome: string;
  /** Angle of turn, rad, anticlockwise; flat bodies turn by more than 2π. */
  turn: number;
  /** Direction in which the body fell or leaned at the end, rad, anticlockwise from the initial lean,
   * 0 to 2π. */
  direction: number;
}

/** The result of each flick; an empty list for a refused set-up. */
export function simulateFlicks(core: Core, setup: Readonly<Setup>): Flick[] {
  try {
    const { body, start, contactLaw, options } = simulationInput(core, setup);
    const trials = scatteredStarts(setup, body).map((start) => ({ start, frictionScale: 1 }));
    // This tolerance gives angles to 1e-4 degrees, as in rimroll.topple.
    const coarse = { ...options, duration: 10, rtol: 1e-6 };
    return core
      .falls(body, contactLaw, coarse, trials)
      .map(({ outcome, turn: firstTurn, endYaw }) => {
        const yawChange = endYaw - start.yaw;
        // A body released while rising turns from its tilt maximum, not from the release.
        const turn = outcome === "rocked" ? firstTurn : yawChange;
        return { outcome, turn, direction: wrapped(yawChange) };
      });
  } catch (error) {
    reasonOrRethrow(error);
    return [];
  }
}

const wrapped = (angle: number) => angle - 2 * Math.PI * Math.floor(angle / (2 * Math.PI));
