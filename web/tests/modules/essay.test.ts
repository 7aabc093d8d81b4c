// The essay: its numbers are those of the core, and its scenes show what they say.

import { readFileSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import { valuesOf } from "../../src/essay/control";
import { computeLines } from "../../src/essay/curve";
import { cameUp, factsOf, numbersOf, SCENES } from "../../src/essay/scenes";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { passageFrom } from "../../src/verdict/passage";
import { loadCore, motionOf } from "../given/core";

const PROSE = readFileSync(new URL("../../index.html", import.meta.url), "utf8");

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

const sceneOf = (id: string) => SCENES.find((scene) => scene.id === id)!;

test("the numbers in the prose are those of the core", () => {
  const written = [...PROSE.matchAll(/data-number="([^"]+)"\s*>([^<]+)<\/b\s*>/g)].map(
    ([, name, text]) => [name, text!.trim()],
  );
  const computed = numbersOf(core);
  expect(written.length).toBe(PROSE.split("data-number").length - 1);
  expect(written.length).toBeGreaterThan(8);
  for (const [name, text] of written) expect([name, text]).toEqual([name, computed[name!]]);
});

test("each scene has its section, and each section its scene", () => {
  const essay = PROSE.slice(PROSE.indexOf('<main id="essay">'), PROSE.indexOf('<main id="lab">'));
  const sections = [...essay.matchAll(/<section id="([^"]+)"/g)].map(([, id]) => id);
  expect(sections).toEqual(SCENES.map(({ id }) => id));
});

test("each body of the essay comes down and up again, at both ends of its control", () => {
  for (const { id, setup, control } of SCENES) {
    const parts: Partial<Setup>[] =
      control.kind === "quantity"
        ? valuesOf(control, 5).map((value) => control.setup(value))
        : control.kind === "choice"
          ? control.options.map((option) => option.setup)
          : [{}];
    for (const part of parts) {
      const motion = motionOf(core, { ...setup, ...part });
      const what = `${id} ${JSON.stringify(part)}: ${motion.message}`;
      expect(passageFrom(motion, 0), what).toBeDefined();
      motion.forget();
    }
  }
});

test("the angle hardly depends on the hand, and the gap does", () => {
  const { setup, control } = sceneOf("hand");
  if (control.kind !== "quantity") throw new Error("the hand has a slider");
  const [fine, coarse] = valuesOf(control, 2).map((value) => {
    const motion = motionOf(core, { ...setup, ...control.setup(value) });
    return passageFrom(motion, 0)!;
  });
  expect(coarse!.minTilt / fine!.minTilt).toBeGreaterThan(90);
  expect(Math.abs(coarse!.angle / fine!.angle - 1)).toBeLessThan(0.03);
});

test("the limit falls from ice to rubber, and a flatter cylinder turns further", () => {
  const lineOf = (id: string, name: string) => {
    const { control, curve = [], setup } = sceneOf(id);
    if (control.kind !== "quantity") throw new Error(`${id} has a slider`);
    const setups = valuesOf(control, 9).map((value) => ({ ...setup, ...control.setup(value) }));
    return computeLines(core, curve, setups).find((line) => line.name === name)!.angles;
  };
  for (const [id, name] of [
    ["friction", "limit on this table"],
    ["tall-and-flat", "limit without slip"],
  ] as const) {
    const angles = lineOf(id, name);
    for (let k = 1; k < angles.length; k++)
      expect(angles[k]!).toBeLessThanOrEqual(angles[k - 1]! + 1e-9);
  }
  // π√5, a uniform disk (Srinivasan & Ruina 2008).
  expect(lineOf("tall-and-flat", "limit without slip")[0]).toBeCloseTo(180 * Math.sqrt(5), 9);
});

test("a guess is compared in whole degrees", () => {
  const setup = { ...INITIAL, ...sceneOf("question").setup };
  const passage = passageFrom(motionOf(core, setup), 0)!;
  const said = (degrees: number) =>
    cameUp(factsOf(passage, { noSlip: 0 } as never, setup, (degrees * Math.PI) / 180));
  const turned = Math.round((Math.abs(passage.angle) * 180) / Math.PI);
  expect(said(180)).toBe(
    `You said 180°, straight across. It came up at ${turned}°. That is ${turned - 180}° beyond your guess.`,
  );
  expect(said(turned + 20)).toContain("20° short of your guess");
  expect(said(turned - 2)).toContain("Well guessed!");
});
