// The fall of a held body if the hand let go at rest now. A fall is computed faster than a complete
// motion, so that the preview can follow the hand.

import type { Core, Fall, Theory } from "../core/core";
import { reasonOrRethrow } from "../core/reason";
import { simulationInput } from "../setup/simulation_input";
import { type Held, ZERO_RATE, leanFields, releasedSetup } from "../setup/release";
import type { Setup } from "../setup/setup";

export interface Preview {
  /** Tilt and yaw of the held body, degrees. */
  lean: Pick<Setup, "tilt" | "yaw">;
  /** The first turn; undefined if it is refused. */
  fall: Fall | undefined;
  theory: Theory | undefined;
}

export function previewOf(core: Core, setup: Readonly<Setup>, held: Held): Preview {
  const lean = leanFields(held);
  try {
    const { body, start, contactLaw, options } = simulationInput(core, {
      ...setup,
      ...releasedSetup(held, ZERO_RATE, setup),
    });
    const [fall] = core.falls(body, contactLaw, options, [{ start, frictionScale: 1 }]);
    return { lean, fall, theory: core.theory(body, start, contactLaw, options.gravity) };
  } catch (error) {
    reasonOrRethrow(error);
    return { lean, fall: undefined, theory: undefined };
  }
}
