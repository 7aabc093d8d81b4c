// Repeats a release with the scatter of a human hand and computes where the body falls.

import type { Core, Fall } from "../core/core";
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

/** Flicks that are computed at once; they take a few ms. */
const PART = 5;

/** The result of each flick; an empty list for a refused set-up. */
export const simulateFlicks = (core: Core, setup: Readonly<Setup>): Flick[] => [
  ...flicksOf(core, setup),
];

/** The results of the flicks, computed as they are asked for; none for a refused set-up. */
export function* flicksOf(core: Core, setup: Readonly<Setup>): Generator<Flick, void> {
  try {
    const { body, start, contactLaw, options } = simulationInput(core, setup);
    const trials = scatteredStarts(setup, body).map((start) => ({ start, frictionScale: 1 }));
    // This tolerance gives angles to 1e-4 degrees, as in rimroll.topple.
    const coarse = { ...options, duration: 10, rtol: 1e-6 };
    for (let first = 0; first < trials.length; first += PART)
      for (const fall of core.falls(body, contactLaw, coarse, trials.slice(first, first + PART)))
        yield flickOf(fall, start.yaw);
  } catch (error) {
    reasonOrRethrow(error);
  }
}

function flickOf({ outcome, turn: firstTurn, endYaw }: Fall, startYaw: number): Flick {
  const yawChange = endYaw - startYaw;
  // A body released while rising turns from its tilt maximum, not from the release.
  const turn = outcome === "rocked" ? firstTurn : yawChange;
  return { outcome, turn, direction: wrapped(yawChange) };
}

const wrapped = (angle: number) => angle - 2 * Math.PI * Math.floor(angle / (2 * Math.PI));
