// Pairs of set-ups that are worth a look.

import { HAND_ERROR, type Setup } from "../setup/setup";

/** A comparison: changes of the set-up A, and the set-up B beside it. */
export interface Pair {
  part: Partial<Setup>;
  other: Setup;
}

/** A start by hand, whose smallest gap a real table could have. */
const BY_HAND: Partial<Setup> = { sideways: HAND_ERROR, duration: 2 };

const START: Partial<Setup> = { ...BY_HAND, tilt: 20, tilt_rate: 0, twist: 0, floor: "rest" };

export const PRESETS = {
  /** One can on two tables: its rim slips on the first and rolls on the second. */
  ice: (setup: Readonly<Setup>): Pair =>
    pair(setup, { ...START, law: "coulomb", rolling: 0 }, { friction: 0.03 }, { friction: 0.8 }),
  /** Two bodies on one table. */
  coin: (setup: Readonly<Setup>): Pair =>
    pair(
      setup,
      { ...START, law: "coulomb", friction: 0.5 },
      { body: "can_2007" },
      { body: "coin" },
    ),
  /** The same start with the error to the other side. */
  mirror: (setup: Readonly<Setup>): Pair => ({ part: {}, other: mirrored(setup) }),
  /** The motion stays as it is while the visitor changes the set-up. */
  keep: (setup: Readonly<Setup>): Pair => ({ part: {}, other: { ...setup } }),
} as const;

export type PresetName = keyof typeof PRESETS;

function pair(
  setup: Readonly<Setup>,
  both: Partial<Setup>,
  a: Partial<Setup>,
  b: Partial<Setup>,
): Pair {
  return { part: { ...both, ...a }, other: { ...setup, ...both, ...b } };
}

/** The start seen in a mirror that stands upright along the lean. A floor that moves stays as it is. */
export const mirrored = (setup: Readonly<Setup>): Setup => ({
  ...setup,
  sideways: -setup.sideways || 0,
  twist: -setup.twist || 0,
});
