// The core in the page against the closed forms of the paper.

import { beforeAll, describe, expect, test } from "vitest";
import type { Body, Core, State } from "../../src/core/core";
import { loadCore } from "../given/core";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

const DEGREES = 180 / Math.PI;
const GRAVITY = 9.8;
const START: State = {
  tilt: Math.PI / 6,
  tiltRate: -0.5,
  yaw: 0,
  yawRate: 0.005,
  spin: 0,
  spinRate: 0.005,
};

const noSlip = ({ mass, radius, height, transverseInertia }: Body) => {
  const k = transverseInertia + mass * height ** 2;
  return Math.PI * Math.sqrt((k + mass * radius ** 2) / k);
};

const frictionless = ({ mass, radius, transverseInertia }: Body) =>
  Math.PI * Math.sqrt((transverseInertia + mass * radius ** 2) / transverseInertia);

const theory = (body: Body, law: "no_slip" | "frictionless" = "no_slip") =>
  core.theory(body, START, { law }, GRAVITY);

describe("limiting angles of turn", () => {
  test("of the can are 202.287° and 220.969°", () => {
    const limits = theory(core.preset("can_2007"));
    expect(limits.noSlip * DEGREES).toBeCloseTo(202.28719483, 8);
    expect(limits.frictionless * DEGREES).toBeCloseTo(220.96915717, 8);
  });

  test("of a ring are 311.769°, whatever the friction", () => {
    const limits = theory(core.preset("ring", 0.05));
    expect(limits.noSlip * DEGREES).toBeCloseTo(311.76914536, 8);
    expect(limits.frictionless * DEGREES).toBeCloseTo(311.76914536, 8);
  });

  test.each([
    [1, 229.92, 296.552],
    [2, 195.456, 229.92],
    [5, 182.66, 190.197],
  ])("of a solid cylinder with its centre %i radii up", (height, rolling, sliding) => {
    const solid = {
      shape: "cylinder",
      mass: 1,
      radius: 0.1,
      length: 0.2 * height,
      base: 0,
    } as const;
    const limits = theory(core.composed(0.1, [solid]));
    expect(limits.noSlip * DEGREES).toBeCloseTo(rolling, 2);
    expect(limits.frictionless * DEGREES).toBeCloseTo(sliding, 2);
  });

  test.each(["soda_can", "beer_bottle", "coin", "battery", "euler_disk"] as const)(
    "of a %s are π√(J/K) and π√((A+mR²)/A)",
    (name) => {
      const body = core.preset(name, 0);
      const limits = theory(body);
      expect(limits.noSlip).toBeCloseTo(noSlip(body), 12);
      expect(limits.frictionless).toBeCloseTo(frictionless(body), 12);
    },
  );
});

test("the can needs a friction of 0.356 to roll through, and balances at tan φ = R/H", () => {
  const can = core.preset("can_2007");
  const { neededFriction, balanceTilt } = theory(can);
  expect(neededFriction).toBeCloseTo(0.35577798, 7);
  expect(Math.tan(balanceTilt)).toBeCloseTo(can.radius / can.height, 12);
});

describe("the paper's release", () => {
  test.each([
    ["no_slip", 202.6546207673, 0.24308731, 1.83292507e-4],
    ["frictionless", 221.1530871945, 0.17648604, 9.65920625e-5],
  ] as const)("%s turns the can by %d°", (law, angle, time, tilt) => {
    const motion = core.simulate(
      core.preset("can_2007"),
      START,
      { law },
      {
        duration: 2,
        gravity: GRAVITY,
        rtol: 1e-12,
        maxSteps: 100_000,
      },
    );
    const [turn] = motion.turns;
    expect(motion.status).toBe("finished");
    expect((turn?.angle as number) * DEGREES).toBeCloseTo(angle, 6);
    expect(turn?.t).toBeCloseTo(time, 7);
    expect((turn?.minTilt as number) / tilt).toBeCloseTo(1, 6);
    expect(theory(core.preset("can_2007"), law).here).toBeGreaterThan(3.5);
    motion.forget();
  });
});
