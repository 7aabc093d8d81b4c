// Motions as the page uses them.

import { beforeAll, describe, expect, test } from "vitest";
import { type Core, Refused } from "../../src/core/core";
import { simulationInput } from "../../src/setup/simulation_input";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { Chance } from "../given/chance";
import { loadCore } from "../given/core";
import { likelySetup } from "../given/setups";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

function simulate(changed: Partial<Setup>) {
  const { body, start, contactLaw, options } = simulationInput(core, { ...INITIAL, ...changed });
  return core.simulate(body, start, contactLaw, options);
}

test("time increases, and a motion can be evaluated at any time", () => {
  const motion = simulate({});
  const times = [...motion.samples(4).column("t")];
  expect(times.every((t, k) => k === 0 || t >= (times[k - 1] as number))).toBe(true);
  expect(times[0]).toBe(0);
  expect(times.at(-1)).toBe(motion.end);
  expect(motion.at([-1]).moment(0)).toEqual(motion.at([0]).moment(0));
  expect(motion.at([1e9]).moment(0)).toEqual(motion.at([motion.end]).moment(0));
  expect(motion.at([]).length).toBe(0);
});

test("energy is conserved up to the listed losses", () => {
  const chance = new Chance(5);
  for (let k = 0; k < 40; k++) {
    const motion = simulate(likelySetup(chance));
    const [first, last] = [motion.at([0]).moment(0), motion.at([motion.end]).moment(0)];
    const all = (m: typeof first) =>
      m.kinetic_energy + m.potential_energy + m.friction_loss + m.resistance_loss + m.impact_loss;
    expect(all(last) / all(first)).toBeCloseTo(1, 8);
    motion.forget();
  }
});

test("phases follow each other from the release to the end", () => {
  const { phases, end } = simulate({ friction: 0.1, sideways: 0.05 });
  expect(phases.length).toBeGreaterThan(1);
  expect(phases[0]?.start).toBe(0);
  expect(phases.at(-1)?.end).toBe(end);
  for (const [k, phase] of phases.entries()) expect(phase.end).toBe(phases[k + 1]?.start ?? end);
});

test("a freed motion cannot be evaluated", () => {
  const motion = simulate({});
  motion.forget();
  expect(() => motion.at([0])).toThrow("forgotten");
});

test("two motions do not disturb each other", () => {
  const one = simulate({});
  const before = one.at([0.1, 0.2]).column("tilt");
  const other = simulate({ body: "coin", tilt: 50 });
  expect(one.at([0.1, 0.2]).column("tilt")).toEqual(before);
  other.forget();
  expect(one.at([0.1, 0.2]).column("tilt")).toEqual(before);
});

describe("an ending has a status and a message", () => {
  test.each([
    ["face_down", { sideways: 0 }],
    ["toppled", { tilt: 60 }],
    ["finished", { law: "no_slip" }],
    ["painleve", { body: "coin", tilt: 60, tilt_rate: -10, sideways: 0.5, friction: 2.2 }],
  ] as const)("%s", (status, changed) => {
    const motion = simulate(changed);
    expect(motion.status).toBe(status);
    expect(motion.message).toMatch(/^\S.{20,}/);
  });
});

test("invalid input is refused in a sentence", () => {
  // At such a small tilt, the sideways error gives an unbounded yaw rate.
  expect(() => simulate({ tilt: 1e-300 })).toThrow(Refused);
  expect(() => simulate({ tilt: 1e-300 })).toThrow(/^yaw_rate must be between .* rad\/s$/);
});

test("lines are drawn through no fewer moments than steps, and close together", () => {
  for (const changed of [{}, { body: "coin" }] as const) {
    const motion = simulate(changed);
    const moments = motion.curve();
    const yaw = moments.column("yaw");
    expect(moments.length).toBeGreaterThanOrEqual(motion.samples(1).length);
    for (let k = 1; k < yaw.length; k++) {
      if (Math.abs(yaw[k]! - yaw[k - 1]!) > 0.3) throw new Error(`a corner at ${k}`);
    }
    motion.forget();
  }
});
