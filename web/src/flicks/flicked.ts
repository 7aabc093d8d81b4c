// The same release again and again by a human hand, and where the body falls each time.

import { type Core, type Fall, Refused } from "../core/core";
import type { Flicked } from "../lab";
import { posed } from "../setup/posed";
import type { Setup } from "../setup/setup";
import { scattered } from "./scatter";

/** What becomes of each flick; nothing for a set-up that is refused. */
export function flicked(core: Core, setup: Readonly<Setup>): Flicked[] {
  try {
    const { body, start, surface, options } = posed(core, setup);
    const { balanceTilt } = core.theory(body, start, surface, options.gravity);
    const trials = scattered(setup, body).map((start) => ({ start, grip: 1 }));
    // Right to 1e-4 degrees, as rimroll.topple.
    const coarse = { ...options, duration: 10, rtol: 1e-6 };
    return core.falls(body, surface, coarse, trials).map((fall) => ({
      outcome: outcomeOf(fall, balanceTilt),
      direction: cycled(fall.endYaw - start.yaw),
    }));
  } catch (error) {
    if (error instanceof Refused) return [];
    throw error;
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
