// What would become of the body in a hand that let go now, at rest: a fall, which is sooner computed
// than a whole motion, so that it can follow the hand.

import type { Core, Fall, Theory } from "../core/core";
import { reasonOrRethrow } from "../core/reason";
import { simulationInput } from "../setup/simulation_input";
import { type Held, ZERO_RATE, leanFields, releasedSetup } from "../setup/release";
import type { Setup } from "../setup/setup";

export interface Preview {
  /** How the body leans in the hand, degrees. */
  lean: Pick<Setup, "tilt" | "yaw">;
  /** Its fall through the first turn; none for a body that cannot be. */
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
    const [fall] = core.falls(body, contactLaw, options, [{ start, grip: 1 }]);
    return { lean, fall, theory: core.theory(body, start, contactLaw, options.gravity) };
  } catch (error) {
    reasonOrRethrow(error);
    return { lean, fall: undefined, theory: undefined };
  }
}
