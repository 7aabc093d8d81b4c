// rimroll.lab passes a body, a start and a law to the page as a set-up; the page computes with the same
// numbers.

import { beforeAll, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import { simulationInput } from "../../src/setup/simulation_input";
import { toPython } from "../../src/setup/export";
import { fromHash } from "../../src/setup/url";
import { loadCore } from "../given/core";
import { printed } from "../given/python";

// Set-ups of random bodies and starts, and the numbers that they were made from.
const CODE = `
import json, random
from dataclasses import asdict
import rimroll as rr
from rimroll.browser.setup import setup_of
chance = random.Random(7)
for k in range(60):
    m, R, H = chance.uniform(0.01, 2), chance.uniform(0.005, 0.3), chance.choice([0, chance.uniform(0, 0.2)])
    A = m * chance.uniform(0.3, 2) * R**2
    body = chance.choice([rr.bodies.can_2007(), rr.bodies.soda_can(chance.random()),
        rr.Body(m, R, H, A, A * chance.uniform(0.2, 2)), rr.Body(m, R, H, A, A * chance.uniform(0.2, 2))])
    rates = {name: chance.choice([0, chance.uniform(-5, 5)]) for name in ("tilt_rate", "yaw_rate", "spin_rate")}
    start = rr.State(tilt=chance.uniform(0.01, 1.5), yaw=chance.uniform(-3, 3), **rates)
    law = chance.choice([rr.NoSlip(), rr.Frictionless(), rr.Coulomb(chance.uniform(0, 1), restitution=0.3)])
    gravity, duration = chance.uniform(1, 20), chance.uniform(0.1, 3)
    print(json.dumps({"setup": setup_of(body, start, law, duration, gravity), "body": list(asdict(body).values()),
        "start": [start.tilt, start.tilt_rate, start.yaw, start.yaw_rate, start.spin_rate],
        "law": law.name, "numbers": [law.numbers.get("friction"), duration, gravity]}))
`;

interface Given {
  setup: string;
  body: number[];
  start: number[];
  law: string;
  numbers: (number | null)[];
}

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

test("the page computes with the numbers that Python passed", async () => {
  const all = (await printed(CODE)).trim().split("\n");
  expect(all.length).toBe(60);
  let same = 0;
  for (const line of all) {
    const given = JSON.parse(line) as Given;
    const { setup, refusals } = fromHash(given.setup);
    expect(refusals).toEqual([]);
    const { body, start, contactLaw, options } = simulationInput(core, setup);
    const read = [
      [body.mass, body.radius, body.height, body.transverseInertia, body.axialInertia],
      [start.tilt, start.tiltRate, start.yaw, start.yawRate, start.spinRate],
    ].flat();
    const meant = [...given.body, ...given.start];
    for (const [k, value] of read.entries()) {
      const expected = meant[k] as number;
      // The yaw rate is a difference of two numbers of the size of the spin rate.
      const size = Math.abs(expected) + (k === 8 ? Math.abs(start.spinRate) : 0);
      // Neighbouring fills differ by more than the last bit of the moments of inertia.
      const bits = setup.fill > 0 && k < 5 ? 2e-15 : 4e-16;
      expect(Math.abs(value - expected), given.setup).toBeLessThanOrEqual(bits * size);
      if (value === expected) same++;
    }
    expect(contactLaw.law).toBe(given.law);
    if (given.law === "coulomb") expect(contactLaw.friction).toBe(given.numbers[0]);
    expect([options.duration, options.gravity]).toEqual(given.numbers.slice(1));
    expect(toPython({ body, start, contactLaw, options })).toContain("rr.Body(mass=");
  }
  // Where no digits give the same number, the last bit differs.
  expect(same / (60 * 10)).toBeGreaterThan(0.9);
});
