// What the page says about a motion.

import { beforeAll, describe, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import type { Setup } from "../../src/setup/setup";
import { passageFrom } from "../../src/verdict/passage";
import { comparison, ending, story } from "../../src/verdict/words";
import { loadCore } from "../given/core";
import { labWith } from "../given/page";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

function saidOf(changed: Partial<Setup>) {
  const lab = labWith(core, changed);
  const { value: setup } = lab.setup;
  const motion = lab.motion.value!;
  const passage = passageFrom(motion, 0);
  return {
    motion,
    passage,
    story: story(passage, setup),
    theory: comparison(passage, lab.theory.value, setup),
    ending: ending(lab.outcome.value, setup),
  };
}

describe("what the rim did", () => {
  test.each([
    ["rolled", {}, "it rolled all the way"],
    ["slipped", { friction: 0.3 }, "slipped on the way"],
    ["jumped", { tilt_rate: -14, sideways: 0.3, friction: 0.3 }, "jumped off the table"],
  ] as const)("%s", (rim, changed, words) => {
    const { passage, story } = saidOf(changed);
    expect(passage?.rim).toBe(rim);
    expect(story).toContain(words);
  });

  test("is told of the whole turn, not of its swift middle alone", () => {
    // It slides as long as it leans, and rolls while the contact point races.
    const { motion, passage } = saidOf({ sideways: 0.3, friction: 0.1 });
    expect(motion.phases[0]?.kind).toBe("sliding");
    expect(passage?.rim).toBe("slipped");
  });

  test("is not told of laws that leave it no choice", () => {
    expect(saidOf({ law: "no_slip" }).story).not.toMatch(/rolled|slipped|jumped/);
  });
});

test("the lean swings round by the change of yaw, whatever the body does about its axis", () => {
  const { motion, story } = saidOf({ twist: 0.5 });
  const [from, to] = [0, motion.turns[0]?.end ?? 0].map((t) => motion.at([t]).moment(0).yaw);
  const swung = (((to as number) - (from as number)) * 180) / Math.PI;
  expect(story).toContain(`The lean swung round by ${swung.toFixed(1)}°`);
});

describe("the theory", () => {
  test("is so much below or above what happened", () => {
    expect(saidOf({}).theory).toBe("0.06° below what happened here");
    expect(saidOf({ tilt: 5, sideways: 1e-9 }).theory).toBe("what happened here");
  });

  test("is said to be for a body that is not twisted, when it is", () => {
    expect(saidOf({ twist: 0.01 }).theory).toMatch(/here; it is for a body that is not twisted$/);
  });

  test("is said to be for coming down flat, when it does not", () => {
    expect(saidOf({ sideways: 0.3 }).theory).toMatch(/here; it is for coming down flat$/);
  });
});

describe("face down", () => {
  test.each([
    ["without sideways motion", { sideways: 0 }, /without any sideways motion/],
    [
      "also where rolling is resisted",
      { sideways: 0, rolling: 0.001 },
      /without any sideways motion/,
    ],
    ["by resistance", { sideways: 1e-6, rolling: 0.01 }, /rolling resistance stopped/],
    ["too flat to be followed", { sideways: 1e-15 }, /so flat.*larger sideways error/],
  ])("%s", (_how, changed, words) => {
    const { motion, ending } = saidOf(changed);
    expect(motion.status).toBe("face_down");
    expect(ending).toMatch(words);
  });
});
