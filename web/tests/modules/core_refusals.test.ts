// Invalid requests to the core are refused and not misread.

import { beforeAll, describe, expect, test } from "vitest";
import { type Core, type LawName, type Preset, Refused, type Solid } from "../../src/core/core";
import { type SimulationInput, simulationInput } from "../../src/setup/simulation_input";
import { INITIAL } from "../../src/setup/setup";
import { loadCore } from "../given/core";

let core: Core;
let usual: SimulationInput;
beforeAll(async () => {
  core = await loadCore();
  usual = simulationInput(core, INITIAL);
});

function refusal(asked: () => unknown): string {
  try {
    asked();
  } catch (error) {
    if (error instanceof Refused) return error.message;
    throw error;
  }
  return "not refused";
}

const simulate = ({ body, start, contactLaw, options }: SimulationInput) =>
  core.simulate(body, start, contactLaw, options);

const PLATE: Solid = { shape: "disk", mass: 0.01, radius: 0.03, length: 0, base: 0 };

describe("unknown names", () => {
  test("a preset body", () => {
    expect(refusal(() => core.preset("teapot" as Preset))).toMatch(
      /^unknown preset .*: choose from can_2007, .*, euler_disk$/,
    );
  });

  test("a shape, also after valid ones", () => {
    const cone = { ...PLATE, shape: "cone" as Solid["shape"] };
    for (const solids of [[cone], [PLATE, cone], [cone, PLATE]])
      expect(refusal(() => core.composed(0.03, solids))).toMatch(
        /^unknown shape .*: choose from disk, wall, cylinder$/,
      );
  });

  test.each(["simulate", "theory", "falls"] as const)("a law, for %s", (asked) => {
    const { body, start, options } = usual;
    const contactLaw = { law: "ice" as LawName };
    const ask = {
      simulate: () => core.simulate(body, start, contactLaw, options),
      theory: () => core.theory(body, start, contactLaw, options.gravity),
      falls: () => core.falls(body, contactLaw, options, [{ start, frictionScale: 1 }]),
    }[asked];
    expect(refusal(ask)).toMatch(
      /^unknown law .*: choose from no_slip, frictionless, in_place, coulomb/,
    );
  });
});

describe("invalid numbers", () => {
  test.each([
    [
      "not a number",
      () => ({ ...usual, body: { ...usual.body, mass: NaN } }),
      /^mass must be a finite/,
    ],
    [
      "no mass",
      () => ({ ...usual, body: { ...usual.body, mass: 0 } }),
      /^mass must be .* got 0 kg$/,
    ],
    [
      "more inertia than any body has",
      () => ({ ...usual, body: { ...usual.body, axialInertia: 1 } }),
      /^axial_inertia must be at most 2 transverse_inertia/,
    ],
    [
      "upside down",
      () => ({ ...usual, start: { ...usual.start, tilt: 4 } }),
      /^tilt must be inside/,
    ],
    [
      "negative friction",
      () => ({ ...usual, contactLaw: { ...usual.contactLaw, friction: -1 } }),
      /^friction must be/,
    ],
    ["no step", () => ({ ...usual, options: { ...usual.options, maxSteps: NaN } }), /^max_steps/],
    [
      "a negative step",
      () => ({ ...usual, options: { ...usual.options, maxSteps: -1 } }),
      /^max_steps/,
    ],
  ] as const)("%s", (_what, setup, words) => {
    expect(refusal(() => simulate(setup()))).toMatch(words);
  });

  test("a body made of nothing", () => {
    expect(refusal(() => core.composed(0.03, []))).toMatch(/^solids must name at least one/);
  });
});

test("after a refusal the core works as before", () => {
  const coin = core.preset("coin");
  refusal(() => core.preset("teapot" as Preset));
  expect(core.preset("coin")).toEqual(coin);
  expect(simulate(usual).status).toBe("finished");
});
