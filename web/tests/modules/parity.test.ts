// The page's Python code computes the same motion as the page, to the last bit.

import { expect, test } from "vitest";
import { simulationInput } from "../../src/setup/simulation_input";
import { toCsv, toPython } from "../../src/setup/export";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { Chance } from "../given/chance";
import { loadCore } from "../given/core";
import { columnsOf, difference, run } from "../given/python";
import { likelySetup } from "../given/setups";

const SPECIAL: Partial<Setup>[] = [
  {},
  { sideways: 0 }, // comes down flat
  { sideways: -0 },
  { tilt_rate: -3 }, // topples
  { body: "coin", tilt: 60, tilt_rate: -10, sideways: 0.5, friction: 2.2 }, // Painlevé's paradox
  { body: "euler_disk", tilt: 10, twist: 20, rolling: 1e-4, duration: 2 },
  { tilt: 1e-5, sideways: 1e-9 },
  { friction: 0 },
];

test("in Python a set-up's code computes the same bits", async () => {
  const core = await loadCore();
  const chance = new Chance(2007);
  const setups = SPECIAL.map((changed) => ({ ...INITIAL, ...changed }));
  while (setups.length < 80) setups.push(likelySetup(chance));

  const ours = setups.map((setup) => {
    const what = simulationInput(core, setup);
    const motion = core.simulate(what.body, what.start, what.contactLaw, what.options);
    const { status } = motion;
    const csv = toCsv(motion);
    motion.forget();
    return { code: toPython(what), status, csv };
  });
  const theirs = await run(ours.map(({ code }) => code));

  for (const [k, { code, status, csv }] of ours.entries()) {
    expect(theirs[k]?.status, code).toBe(status);
    expect(difference(columnsOf(csv), theirs[k]?.columns ?? new Map()), code).toBe(undefined);
  }
  expect(new Set(ours.map(({ status }) => status)).size).toBeGreaterThan(3);
});
