// The same release again and again by a human hand, and where the body falls each time.

import type { Core, Fall } from "../core/core";
import { reasonFrom } from "../core/reason";
import { posed } from "../setup/posed";
import type { Setup } from "../setup/setup";
import { scattered } from "./scatter";

/** What became of one flick of many. */
export interface Flicked {
  /** `toppled`, `rocked` (up again), or how else it ended. */
  outcome: string;
  /** How far round it came, rad, anticlockwise: flat bodies go round more than once. */
  turn: number;
  /** Where on the table it fell or leaned at last, rad, anticlockwise from where it leaned at first,
   * 0 to 2π. */
  direction: number;
}

/** What becomes of each flick; nothing for a set-up of which there is no motion. */
export function flicked(core: Core, setup: Readonly<Setup>): Flicked[] {
  try {
    const { body, start, surface, options } = posed(core, setup);
    const { balanceTilt } = core.theory(body, start, surface, options.gravity);
    const trials = scattered(setup, body).map((start) => ({ start, grip: 1 }));
    // Right to 1e-4 degrees, as rimroll.topple.
    const coarse = { ...options, duration: 10, rtol: 1e-6 };
    return core.falls(body, surface, coarse, trials).map((fall) => {
      const outcome = outcomeOf(fall, balanceTilt);
      const round = fall.endYaw - start.yaw;
      // One that was let go rising turns from where it was highest.
      const turn = outcome === "rocked" ? fall.turn : round;
      return { outcome, turn, direction: cycled(round) };
    });
  } catch (error) {
    reasonFrom(error);
    return [];
  }
}

/** In the words of rimroll.ensemble. */
function outcomeOf({ ending, turn, endTilt }: Fall, balanceTilt: number): string {
  const cameDown = !Number.isNaN(turn);
  if (ending === "finished") return cameDown ? "rocked" : "hovered";
  if (ending === "toppled" && !cameDown) return "fell_back";
  // Rising, its centre of mass past the rim.
  if (ending === "lifted_off" && cameDown && endTilt > balanceTilt) return "toppled";
  return ending;
}

const cycled = (angle: number) => angle - 2 * Math.PI * Math.floor(angle / (2 * Math.PI));
