// On a floor that moves, the page computes the same bits as Python; on a floor at rest, both cores of the page do.

import { expect, test } from "vitest";
import type { Motion } from "../../src/core/motion";
import { recordOf } from "../../src/floor/ground";
import { toCsv, toPython } from "../../src/setup/export";
import { FIELDS } from "../../src/setup/fields";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { simulationInput } from "../../src/setup/simulation_input";
import { Chance } from "../given/chance";
import { loadCore, loadShakenCore, shakenInput } from "../given/core";
import { columnsOf, difference, run } from "../given/python";
import { likelySetup } from "../given/setups";

const PULSES = Object.keys(FIELDS.pulse.choices) as Setup["pulse"][];
const LANDINGS = Object.keys(FIELDS.flat.choices) as Setup["flat"][];

/** A record of a hand that swings back and forth. */
const RECORD = recordOf(
  Array.from({ length: 60 }, (_, k) => ({
    x: 0.06 * Math.sin(0.3 * k),
    y: 0.01 * Math.sin(0.5 * k),
    t: k / 60,
  })),
);

const SPECIAL: Partial<Setup>[] = [
  // Each pulse under a body that stands, and each landing in the plane of the pulse.
  ...PULSES.map((pulse): Partial<Setup> => ({ pulse, start: "standing" })),
  ...LANDINGS.map((flat): Partial<Setup> => ({ flat, start: "standing", shake: 6, cycles: 3 })),
  { floor: "hand", record: RECORD, start: "standing", friction: 0.9 },
  { floor: "hand", record: RECORD },
  { floor: "hand" },
  { shake: 30, start: "standing" }, // overturns
  { shake: 0, start: "standing" },
  { start: "standing", friction: 0.2 }, // slides flat
  { start: "standing", law: "frictionless" },
  { start: "standing", law: "no_slip", direction: 37, yaw: 20 },
  { vertical: -25, start: "standing", friction: 0.3 }, // leaves the table
  { vertical: -25 }, // leaves the table, leaning
  { direction: 90 },
];

function shakenSetup(chance: Chance): Partial<Setup> {
  const floor = chance.one(["pulse", "hand"] as const);
  return {
    ...likelySetup(chance),
    floor,
    record: RECORD,
    pulse: chance.one(PULSES),
    // The first slip of a base on a floor that turns its direction takes very many steps.
    start: floor === "hand" ? "tilted" : chance.one(["tilted", "standing"]),
    flat: chance.one(LANDINGS),
    shake: chance.between(0, 20),
    vertical: chance.one([0, chance.between(-12, 12)]),
    period: chance.between(0.05, 0.5),
    cycles: chance.one([1, chance.between(0.3, 4)]),
    direction: chance.between(-180, 180),
  };
}

function written(motion: Motion): { status: string; csv: string } {
  const { status } = motion;
  const csv = toCsv(motion);
  motion.forget();
  return { status, csv };
}

test("on a floor that moves, a set-up's code computes the same bits in Python", async () => {
  const core = await loadShakenCore();
  const chance = new Chance(1940);
  const setups = SPECIAL.map((changed): Setup => ({
    ...INITIAL,
    floor: "pulse",
    duration: 1.5,
    ...changed,
  }));
  while (setups.length < 60) setups.push({ ...INITIAL, ...shakenSetup(chance) });

  const kinds = new Set<string>();
  const ours = setups.map((setup) => {
    const input = shakenInput(core, setup);
    const motion = input.shaking?.simulation(input).now() as Motion;
    for (const { kind } of motion.phases) kinds.add(kind);
    return { code: toPython(input), ...written(motion) };
  });
  const theirs = await run(ours.map(({ code }) => code));

  for (const [k, { code, status, csv }] of ours.entries()) {
    expect(theirs[k]?.status, code).toBe(status);
    expect(difference(columnsOf(csv), theirs[k]?.columns ?? new Map()), code).toBe(undefined);
  }
  expect(new Set(ours.map(({ status }) => status)).size).toBeGreaterThan(2);
  expect(kinds).toEqual(
    new Set(["standing", "sliding_flat", "flying_level", "rolling", "sliding", "flying", "lying"]),
  );
});

test("on a floor at rest, both cores compute the same bits", async () => {
  const [core, other] = [await loadCore(), await loadShakenCore()];
  const chance = new Chance(7);
  const setups = [INITIAL, { ...INITIAL, tilt_rate: -3 }, { ...INITIAL, sideways: 0 }];
  while (setups.length < 60) setups.push(likelySetup(chance));
  for (const setup of setups) {
    const { body, start, contactLaw, options } = simulationInput(core, setup);
    const [here, there] = [core, other].map((one) =>
      written(one.simulate(body, start, contactLaw, options)),
    );
    expect(there).toEqual(here);
    expect(other.theory(body, start, contactLaw, options.gravity)).toEqual(
      core.theory(body, start, contactLaw, options.gravity),
    );
  }
});
