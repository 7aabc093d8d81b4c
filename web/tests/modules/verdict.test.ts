// The verdict on a motion.

import { Matrix4, Quaternion, Vector3 } from "three";
import { beforeAll, describe, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import type { Moment } from "../../src/core/motion";
import { formatDuration } from "../../src/format";
import { bodyAngleAlongContact } from "../../src/lab";
import { Hands } from "../../src/scene/hands";
import { setPose } from "../../src/scene/pose";
import { simulationInput } from "../../src/setup/simulation_input";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { contentInHand, contentInMotion } from "../../src/verdict/tiles";
import { passageFrom } from "../../src/verdict/passage";
import { comparison, ending, story } from "../../src/verdict/words";
import { Chance } from "../given/chance";
import { loadCore } from "../given/core";
import { labWith } from "../given/page";
import { likelySetup } from "../given/setups";

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
    story: story(passage, motion, setup),
    theory: comparison(
      passage && Math.abs(passage.angle),
      passage?.minTilt,
      lab.theory.value,
      setup,
    ),
    ending: ending(lab.outcome.value, setup),
  };
}

describe("what the rim does", () => {
  test.each([
    ["rolled", {}, "it rolls all the way"],
    ["slipped", { friction: 0.3 }, "slips on the way"],
    ["jumped", { tilt_rate: -14, sideways: 0.3, friction: 0.3 }, "jumps off the table"],
  ] as const)("%s", (rim, changed, words) => {
    const { passage, story } = saidOf(changed);
    expect(passage?.rim).toBe(rim);
    expect(story).toContain(words);
  });

  test("is reported for the whole turn, not for its fast middle alone", () => {
    // This body slides while it leans, and rolls while the contact point races.
    const { motion, passage } = saidOf({ sideways: 0.3, friction: 0.1 });
    expect(motion.phases[0]?.kind).toBe("sliding");
    expect(passage?.rim).toBe("slipped");
  });

  test("is not reported under the ideal laws", () => {
    expect(saidOf({ law: "no_slip" }).story).not.toMatch(/rolls|slips|jumps/);
  });
});

test("the contact point runs round by the change of yaw, whatever the body does about its axis", () => {
  const { motion, story } = saidOf({ twist: 0.5 });
  const [from, to] = [0, motion.turns[0]?.end ?? 0].map((t) => motion.at([t]).moment(0).yaw);
  const swung = (((to as number) - (from as number)) * 180) / Math.PI;
  expect(story).toContain(`the contact point runs round by ${swung.toFixed(1)}°`);
});

describe("the body itself", () => {
  /** Direction of a mark on the body after tipping it upright the shortest way, rad. */
  function markOf(moment: Moment): number {
    const placed = new Matrix4();
    setPose(placed, { ...moment, x: 0, y: 0, z: 0 });
    const axis = new Vector3(0, 0, 1).transformDirection(placed);
    const upright = new Quaternion().setFromUnitVectors(axis, new Vector3(0, 0, 1));
    const mark = new Vector3(1, 0, 0).transformDirection(placed).applyQuaternion(upright);
    return Math.atan2(mark.y, mark.x);
  }

  test("turns as far as a mark on it, in every motion", () => {
    const chance = new Chance(7);
    for (let k = 0; k < 60; k++) {
      const lab = labWith(core, { ...likelySetup(chance), duration: 1 });
      const motion = lab.motion.value;
      if (!motion || motion.end === 0) continue;
      for (const part of [0.2, 0.55, 0.9]) {
        lab.clock.time.value = part * motion.end;
        const { bodyAngle, start } = lab.turnProgress.value!;
        const turned = markOf(lab.moment.value!) - markOf(motion.at([start]).moment(0));
        expect(Math.cos(bodyAngle - turned)).toBeCloseTo(1, 9);
      }
    }
  });

  test("does not turn while its contact point runs round, and the verdict says so", () => {
    const { passage, story } = saidOf({});
    expect(Math.abs(passage!.bodyAngle)).toBeLessThan(1e-3);
    expect(story).toMatch(
      /the contact point runs round by 202\.4°.*; the can itself turns 0\.0°\./,
    );
  });

  test("turns in either direction when it is twisted", () => {
    expect(saidOf({ twist: 0.5 }).story).toMatch(/itself turns \d+\.\d° the same way\./);
    expect(saidOf({ twist: 0.5, sideways: -0.3 }).story).toMatch(/itself turns .* the other way\./);
    expect(saidOf({ twist: 0.5, body: "coin" }).story).toMatch(/the coin itself turns/);
  });

  test("is positive in the direction of the contact point", () => {
    const lab = labWith(core, { twist: -0.5, sideways: -0.01 });
    const turning = lab.turnProgress.value!;
    expect(turning.turn!.angle).toBeLessThan(0);
    lab.clock.time.value = turning.turn!.end;
    expect(lab.turnProgress.value!.bodyAngle).toBeLessThan(0);
    expect(bodyAngleAlongContact(lab.turnProgress.value!)).toBe(-lab.turnProgress.value!.bodyAngle);
  });
});

test("the verdict says from when to when the angle is counted", () => {
  const { motion } = saidOf({});
  const [first, second] = motion.turns;
  expect(saidOf({}).story).toMatch(
    `From the release, down and up to the next tilt maximum at ${formatDuration(first!.end)}, the contact`,
  );
  const later = story(passageFrom(motion, second!.start), motion, INITIAL);
  expect(later).toMatch(/^From the tilt maximum at \S+\sm?s, down and up to the next tilt maximum/);
  const fallen = saidOf({ tilt_rate: -3 });
  expect(fallen.story).toMatch(/^From the release, down and up to its fall at/);
  expect(fallen.ending).toMatch(/^It falls over after/);
});

describe("in the hand", () => {
  const DEGREE = Math.PI / 180;
  function previewed(held: { tilt: number; yaw: number }, changed: Partial<Setup> = {}) {
    const lab = labWith(core, changed);
    lab.held.value = { tilt: held.tilt * DEGREE, yaw: held.yaw * DEGREE };
    const { said, turned } = contentInHand(lab.preview.value!, lab.setup.value);
    return { lab, said, turned };
  }

  test("the preview is the motion that follows when the hand lets go", () => {
    const { lab, said, turned } = previewed({ tilt: 12.3, yaw: 40 });
    new Hands(lab).release(false);
    expect(lab.setup.value).toMatchObject({ tilt: 12.3, yaw: 40 });
    const angle = (lab.motion.value!.turns[0]!.angle * 180) / Math.PI;
    expect(turned.number).toBe(`${Math.abs(angle).toFixed(1)}°`);
    expect(said).toMatch(/^In your hand it leans by 12\.3° toward 40°/);
    expect(said).toContain(`its contact point would run round by ${turned.number}`);
    expect(lab.preview.value).toBe(undefined);
  });

  test.each([
    ["leanFields past its balance", 60, {}, /would fall over toward the side it leans to, after/],
    ["without any sideways motion", 20, { sideways: 0 }, /would come down flat, after/],
    ["followed for too short a time", 20, { duration: 0.1 }, /not have come down and up again/],
  ] as const)("%s", (_how, tilt, changed, words) => {
    expect(previewed({ tilt, yaw: 0 }, changed).said).toMatch(words);
  });
});

describe("the theory", () => {
  test("is so much below or above what happens", () => {
    expect(saidOf({}).theory).toBe("0.06° below the computed turn");
    expect(saidOf({ tilt: 5, sideways: 1e-9 }).theory).toBe("as computed here");
  });

  test("is said to be for a body that is not twisted, when it is", () => {
    expect(saidOf({ twist: 0.01 }).theory).toMatch(
      /turn; it holds for a body that is not twisted$/,
    );
  });

  test("is said to be for coming down flat, when it does not", () => {
    expect(saidOf({ sideways: 0.3 }).theory).toMatch(
      /turn; it holds for a body that comes down flat$/,
    );
  });
});

describe("how small and how fast it is", () => {
  test.each([
    ["the paper's can", {}, "a gap of 3.5\u00a0µm", /^times round per second, at 7\.6\skm\/s$/],
    [
      "by a hand",
      { sideways: 0.02 },
      "a gap of 140\u00a0µm",
      /^times round per second, at \d+\sm\/s$/,
    ],
    ["not coming down", { tilt: 60 }, "", /^times round per second$/],
  ] as const)("%s", (_what, changed, gap, speed) => {
    const lab = labWith(core, changed);
    const passage = passageFrom(lab.motion.value!, 0);
    const { lowest, then } = contentInMotion(lab, passage);
    expect(lowest.note).toBe(gap);
    expect(then.note).toMatch(speed);
    if (!passage) return;
    // Compare with the height of the highest point of the rim in the mechanics.
    const { radius } = simulationInput(core, lab.setup.value).body;
    const moment = lab.motion.value!.at([lab.motion.value!.turns[0]!.t]).moment(0);
    const up = 2 * radius * Math.sin(moment.tilt) * 1e6;
    expect(Number.parseFloat(gap.replace("a gap of ", ""))).toBeCloseTo(
      Number(up.toPrecision(2)),
      9,
    );
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
    ["by resistance", { sideways: 1e-6, rolling: 0.01 }, /rolling resistance stops/],
    ["too flat to be followed", { sideways: 1e-15 }, /so flat.*larger sideways error/],
  ])("%s", (_how, changed, words) => {
    const { motion, ending } = saidOf(changed);
    expect(motion.status).toBe("face_down");
    expect(ending).toMatch(words);
  });
});
