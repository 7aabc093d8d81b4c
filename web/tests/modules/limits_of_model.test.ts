// What the model leaves out, in numbers of the motion that is shown.

import { beforeAll, describe, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import type { Validity } from "../../src/core/motion";
import { limitsOf, touching } from "../../src/limits/limits";
import { BY_HAND, type Setup } from "../../src/setup/setup";
import { passageFrom } from "../../src/verdict/passage";
import { loadCore } from "../given/core";
import { labWith } from "../given/page";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

function of(changed: Partial<Setup>) {
  const lab = labWith(core, changed);
  const outcome = lab.outcome.value;
  if (!("motion" in outcome)) throw new Error(outcome.refused);
  const { motion, input } = outcome;
  const passage = passageFrom(motion, 0)!;
  return { motion, input, passage, numbers: passage.validity };
}

const exceeded = (numbers: Validity) =>
  limitsOf(numbers)
    .filter((limit) => limit.exceeded)
    .map(({ name }) => name);

test("a can that comes down nearly flat is beyond any real can, in every respect that has a limit", () => {
  const { numbers } = of({});
  expect(numbers.gap * 1e6).toBeCloseTo(3.5, 1);
  expect(numbers.contactSpeed).toBeGreaterThan(7000);
  expect(numbers.soundTime * 1e6).toBeCloseTo(20.4, 1); // 10.2 cm at 5 km/s
  expect(exceeded(numbers).length).toBe(4);
});

test("one that a hand lets go is within the limits but for its losses", () => {
  const { numbers } = of({ sideways: 0.1 });
  expect(exceeded(numbers)).toEqual(["Energy lost in this turn"]);
});

test("the can that the lab opens with is within all limits if rim and table are fine", () => {
  const { numbers } = of(BY_HAND);
  expect(exceeded(numbers)).toEqual(["Smallest gap under the rim"]);
  const [fine, coarse] = numbers.unevenness;
  expect(numbers.gap).toBeGreaterThan(fine);
  expect(numbers.gap).toBeLessThan(coarse);
  expect(numbers.lossRatio).toBeCloseTo(0.05, 2);
});

describe("a base that is nearer to the table than their unevenness", () => {
  const RADIUS = 0.0509; // m, about that of the paper's can

  test("is so between two crossings of a tilt", () => {
    const { motion, passage } = of({ sideways: 0.02 });
    const [turn] = motion.turns;
    const unevenness = 3e-4;
    const tiltAt = (time: number) => motion.at([time]).moment(0).tilt;
    const crossing = (low: number, high: number, falls: boolean) => {
      for (let k = 0; k < 60; k++) {
        const middle = (low + high) / 2;
        if (tiltAt(middle) > unevenness / (2 * RADIUS) === falls) low = middle;
        else high = middle;
      }
      return low;
    };
    const [from, to] = [crossing(0, turn!.t, true), crossing(turn!.t, turn!.end, false)];
    const yawAt = (time: number) => motion.at([time]).moment(0).yaw;
    const near = touching(motion, passage, RADIUS, unevenness)!;
    expect(near.time / (to - from)).toBeCloseTo(1, 2);
    expect(near.angle / Math.abs(yawAt(to) - yawAt(from))).toBeCloseTo(1, 2);
    expect(near.angle).toBeLessThan(Math.abs(turn!.angle));
  });

  test("is so for the whole turn if the unevenness is coarse, and never if it is fine", () => {
    const { motion, passage } = of({ sideways: 0.02 });
    const near = touching(motion, passage, RADIUS, 1)!;
    expect(near.time).toBeCloseTo(passage.end - passage.start, 6);
    expect(near.angle).toBeCloseTo(Math.abs(passage.angle), 6);
    expect(touching(motion, passage, RADIUS, 1e-5)).toBeUndefined();
  });
});

describe("the largest force", () => {
  test("is that of the mechanics at the smallest tilt", () => {
    const { numbers, motion, input } = of({ law: "no_slip", sideways: 0.1 });
    const weight = input.body.mass * input.options.gravity;
    const times = Array.from({ length: 20_001 }, (_, k) => (motion.turns[0]!.end * k) / 20_000);
    const forces = motion.at(times).column("normal_force");
    const most = forces.reduce((most, force) => Math.max(most, force)) / weight;
    expect(numbers.forceRatio / most).toBeCloseTo(1, 2);
  });
});

test("the energy lost is what friction and resistance took, over the largest kinetic energy", () => {
  expect(of({ law: "no_slip" }).numbers.lossRatio).toBe(0);
  const { numbers, motion } = of({ friction: 0.1, sideways: 0.2 });
  const { friction_loss } = motion.at([motion.turns[0]!.end]).moment(0);
  const kinetic = motion.samples(1).column("kinetic_energy");
  const t = motion.samples(1).column("t");
  const most = kinetic.reduce(
    (most, energy, k) => (t[k]! <= motion.turns[0]!.end ? Math.max(most, energy) : most),
    0,
  );
  expect(numbers.lossRatio).toBe(friction_loss / most);
  expect(numbers.lossRatio).toBeGreaterThan(1e-3);
});
