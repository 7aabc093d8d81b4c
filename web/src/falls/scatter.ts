// Scatters repeated releases in the same way as rimroll.Release.

import type { Body, State } from "../core/core";
import { startOf } from "../setup/simulation_input";
import type { Setup } from "../setup/setup";

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
