// The story: each step shows what its text says.

import { beforeAll, describe, expect, test } from "vitest";
import { SPEEDS } from "../../src/setup/playback";
import type { Core } from "../../src/core/core";
import { simulateFlicks } from "../../src/falls/flicks";
import { tallyOf } from "../../src/falls/tally";
import { FIELD_NAMES } from "../../src/setup/fields";
import { INITIAL, read } from "../../src/setup/setup";
import { showStep, type Step, STEPS } from "../../src/story/steps";
import { passageFrom } from "../../src/verdict/passage";
import { loadCore } from "../given/core";
import { labWith } from "../given/page";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

const step = (title: string) => STEPS.find((one) => one.title === title) as Step;

describe.each(STEPS)("$title", ({ setup, speed, shows }) => {
  test("has a set-up that a visitor could enter", () => {
    const all = { ...INITIAL, ...setup };
    for (const name of FIELD_NAMES)
      expect(read(name, String(all[name]))).toEqual({ value: all[name] });
    expect(SPEEDS).toContain(speed);
  });

  test("has something to show", () => {
    const lab = labWith(core, setup);
    expect(lab.motion.value?.status).toMatch(/^(finished|toppled)$/);
    const falls = simulateFlicks(core, lab.setup.value);
    if (shows === "flicks") expect(tallyOf(falls).others).toBeLessThan(5);
  });
});

test("it rolls round in less than a ten-thousandth of a second", () => {
  const lab = labWith(core, step("It is rolling").setup);
  const passage = passageFrom(lab.motion.value!, 0)!;
  expect(passage.validity.passageTime).toBeLessThan(1e-4);
  expect(passage.angle).toBeGreaterThan(Math.PI);
});

test("the angle is close to 202° every time", () => {
  const { setup } = step("The angle is the same every time");
  const falls = simulateFlicks(core, { ...INITIAL, ...setup });
  const sizes = falls.map(({ turn }) => (Math.abs(turn) * 180) / Math.PI);
  for (const size of sizes) expect(Math.abs(size - 202.3)).toBeLessThan(1);
  const { left, right, others } = tallyOf(falls);
  expect(others).toBe(0);
  for (const side of [left, right]) {
    expect(side.count).toBeGreaterThan(10);
    expect(Math.abs(side.mean - 202.3)).toBeLessThan(0.4);
  }
});

describe("a step that is shown", () => {
  test("stops where the body has come up for the first time, and says so", () => {
    const lab = labWith(core);
    const first = STEPS[0] as Step;
    showStep(lab, first, true);
    const [turn] = lab.motion.value!.turns;
    for (let k = 0; k < 100_000 && lab.clock.playing.value; k++) lab.clock.advance(1 / 60);
    expect(lab.clock.playing.value).toBe(false);
    expect(lab.clock.time.value).toBe(turn!.end);
    const DEGREES = 180 / Math.PI;
    expect(lab.moment.value!.tilt * DEGREES).toBeGreaterThan(18);
    // The angle shown and the text agree.
    const angle = lab.turnProgress.value!.angle * DEGREES;
    expect(angle).toBeCloseTo(turn!.angle * DEGREES, 9);
    expect(first.text).toContain(`${(angle - 180).toFixed(0)}° to the side`);
    // Playing again shows the rest.
    lab.clock.play();
    for (let k = 0; k < 100_000 && lab.clock.playing.value; k++) lab.clock.advance(1 / 60);
    expect(lab.clock.time.value).toBe(lab.motion.value!.end);
  });

  test("plays from the release, also if the set-up is unchanged", () => {
    const lab = labWith(core);
    showStep(lab, STEPS[0] as Step, true);
    lab.clock.time.value = 1;
    showStep(lab, STEPS[0] as Step, true);
    expect([lab.clock.time.value, lab.clock.playing.value]).toEqual([0, true]);
  });

  test("shows the end of its turn at once with reduced motion", () => {
    const lab = labWith(core, {}, true);
    showStep(lab, STEPS[1] as Step, true);
    showStep(lab, STEPS[0] as Step, false);
    expect(lab.clock.playing.value).toBe(false);
    expect(((lab.turnProgress.value?.angle ?? 0) * 180) / Math.PI).toBeCloseTo(202.75, 1);
  });

  test("removes the flicks of another step", () => {
    const lab = labWith(core, {}, true);
    showStep(lab, STEPS[3] as Step, false);
    expect(lab.flicksShown.value).toBe(42);
    showStep(lab, STEPS[2] as Step, false);
    expect(lab.flicksShown.value).toBe(undefined);
  });
});
