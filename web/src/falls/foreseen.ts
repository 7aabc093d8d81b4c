// What would become of the body in a hand that let go now, at rest: a fall, which is sooner computed
// than a whole motion, so that it can follow the hand.

import type { Core, Fall, Theory } from "../core/core";
import { reasonFrom } from "../core/reason";
import { posed } from "../setup/posed";
import { type Held, STILL, leaning, released } from "../setup/released";
import type { Setup } from "../setup/setup";

export interface Foreseen {
  /** How the body leans in the hand, degrees. */
  lean: Pick<Setup, "tilt" | "yaw">;
  /** Its fall through the first turn; none for a body that cannot be. */
  fall: Fall | undefined;
  theory: Theory | undefined;
}

export function foreseen(core: Core, setup: Readonly<Setup>, held: Held): Foreseen {
  const lean = leaning(held);
  try {
    const { body, start, surface, options } = posed(core, {
      ...setup,
      ...released(held, STILL, setup),
    });
    const [fall] = core.falls(body, surface, options, [{ start, grip: 1 }]);
    return { lean, fall, theory: core.theory(body, start, surface, options.gravity) };
  } catch (error) {
    reasonFrom(error);
    return { lean, fall: undefined, theory: undefined };
  }
}
