// Falls of a body: of a release that is repeated with the scatter of a human hand, and of a held body if it were let go.

import type { Body, Core, Fall, State, Theory } from "../core/core";
import { reasonOrRethrow, simulationInput, startOf } from "../setup/simulation_input";
import type { Setup } from "../setup/setup";
import { type Held, leanFields, releasedSetup, ZERO_RATE } from "../setup/release";

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

// Scatters repeated releases in the same way as rimroll.Release.

/** Standard deviations of a hand's starts about the set-up: the tilt in degrees, rates in rad/s.
 *
 * They are those of rimroll's preset "flick" for tilt rates from 0.15 √(g/R), and those of "let go" for a
 * body that is released at rest, except that its tilt scatters as in a flick. */
export function spreads({ tilt, tilt_rate, gravity }: Readonly<Setup>, { radius }: Body) {
  const rate = Math.abs(tilt_rate);
  const slowest = 0.002 * Math.sqrt(gravity / radius);
  const aside = Math.max(0.05 * rate, slowest);
  return {
    tilt: 0.1 * tilt,
    tilt_rate: Math.max(0.07 * rate, 5 * slowest),
    sideways: aside,
    twist: aside,
  };
}

/** Starts that are normally distributed about the set-up, with the tilt within (0, 90°). */
export function scatteredStarts(setup: Readonly<Setup>, body: Body): State[] {
  const random = normal(setup.seed);
  const unsteadiness = setup.unsteadiness / 100;
  const spread = spreads(setup, body);
  return Array.from({ length: Math.round(setup.flicks) }, () => {
    const [c0, c1, c2, c3] = [random(), random(), random(), random()];
    const tilt = setup.tilt + unsteadiness * spread.tilt * c0;
    return startOf({
      ...setup,
      tilt: Math.min(Math.max(tilt, 0.01 * setup.tilt), Math.max(89, setup.tilt)),
      tilt_rate: setup.tilt_rate + unsteadiness * spread.tilt_rate * c1,
      sideways: setup.sideways + unsteadiness * spread.sideways * c2,
      twist: setup.twist + unsteadiness * spread.twist * c3,
    });
  });
}

/** Normally distributed numbers by Box and Muller, from uniform ones by a small generator with a seed
 * (Bob Jenkins's 32-bit "small fast" generator). */
function normal(seed: number): () => number {
  let [a, b, c, d] = [0xf1ea5eed, seed | 0, seed | 0, seed | 0];
  const uniform = () => {
    const e = (a - ((b << 27) | (b >>> 5))) | 0;
    a = b ^ ((c << 17) | (c >>> 15));
    b = (c + d) | 0;
    c = (d + e) | 0;
    d = (e + a) | 0;
    return ((d >>> 0) + 0.5) / 4294967296;
  };
  for (let k = 0; k < 20; k++) uniform();
  return () => {
    const size = Math.sqrt(-2 * Math.log(uniform()));
    return size * Math.cos(2 * Math.PI * uniform());
  };
}

// The fall of a held body if the hand let go at rest now. A fall is computed faster than a complete
// motion, so that the preview can follow the hand.

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
