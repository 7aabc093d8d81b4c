// What the model leaves out, in numbers of the motion that is shown.

import { beforeAll, describe, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import type { Validity } from "../../src/core/motion";
import { limitsOf } from "../../src/limits/words";
import type { Setup } from "../../src/setup/setup";
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

test("a can that comes down nearly flat is beyond any real can, in every respect", () => {
  const { numbers } = of({});
  expect(numbers.gap * 1e6).toBeCloseTo(3.5, 1);
  expect(numbers.contactSpeed).toBeGreaterThan(7000);
  expect(numbers.soundTime * 1e6).toBeCloseTo(20.4, 1); // 10.2 cm at 5 km/s
  expect(exceeded(numbers).length).toBe(5);
});

test("one that a hand lets go is within the limits but for its losses", () => {
  const { numbers } = of({ sideways: 0.1 });
  expect(exceeded(numbers)).toEqual(["Energy lost in this turn"]);
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
