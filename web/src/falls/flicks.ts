// The same release again and again by a human hand, and where the body falls each time.

import type { Core } from "../core/core";
import { reasonOrRethrow } from "../core/reason";
import { simulationInput } from "../setup/simulation_input";
import type { Setup } from "../setup/setup";
import { scatteredStarts } from "./scatter";

/** What became of one flick of many. */
export interface Flick {
  /** In the words of rimroll.ensemble: `toppled`, `rocked` (up again) or another. */
  outcome: string;
  /** How far round it came, rad, anticlockwise: flat bodies go round more than once. */
  turn: number;
  /** Where on the table it fell or leaned at last, rad, anticlockwise from where it leaned at first,
   * 0 to 2π. */
  direction: number;
}

/** What becomes of each flick; nothing for a set-up of which there is no motion. */
export function simulateFlicks(core: Core, setup: Readonly<Setup>): Flick[] {
  try {
    const { body, start, contactLaw, options } = simulationInput(core, setup);
    const trials = scatteredStarts(setup, body).map((start) => ({ start, grip: 1 }));
    // Right to 1e-4 degrees, as rimroll.topple.
    const coarse = { ...options, duration: 10, rtol: 1e-6 };
    return core.falls(body, contactLaw, coarse, trials).map(({ outcome, turn: rocked, endYaw }) => {
      const round = endYaw - start.yaw;
      // One that was let go rising turns from where it was highest.
      const turn = outcome === "rocked" ? rocked : round;
      return { outcome, turn, direction: cycled(round) };
    });
  } catch (error) {
    reasonOrRethrow(error);
    return [];
  }
}

const cycled = (angle: number) => angle - 2 * Math.PI * Math.floor(angle / (2 * Math.PI));
