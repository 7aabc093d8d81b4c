// What a gyroscope in the body shows, beside Python's numbers and its analysis.

import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { beforeAll, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import { bodyRates, toPhyphox } from "../../src/gyro/rates";
import { Star } from "../../src/gyro/section";
import { toPython } from "../../src/setup/export";
import { simulationInput } from "../../src/setup/simulation_input";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { loadCore, motionOf } from "../given/core";
import { printed } from "../given/python";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

const RELEASE: Partial<Setup> = { sideways: 0.02, friction: 0.2, duration: 0.8 };

test("the rates are those of Python", async () => {
  const times = [0, 0.1, 0.176, 0.177, 0.3, 0.53, 0.8];
  const code = `${toPython(simulationInput(core, { ...INITIAL, ...RELEASE }))}
import json
print(json.dumps(motion.evaluate(${JSON.stringify(times)}).body_angular_velocity.tolist()))`;
  const python = JSON.parse((await printed(code)).trim().split("\n").at(-1)!) as number[][];
  const { x, y, z } = bodyRates(motionOf(core, RELEASE).at(times));
  times.forEach((_, k) => {
    const ours = [x[k]!, y[k]!, z[k]!];
    // The sines of this machine and of Python's library may differ in the last bits.
    ours.forEach((rate, axis) => expect(rate).toBeCloseTo(python[k]![axis]!, 10));
  });
});

test("the saved record is read by rimroll gyro, which finds the friction and the turns", async () => {
  const folder = mkdtempSync(join(tmpdir(), "rimroll-"));
  try {
    const file = join(folder, "fall.csv");
    const motion = motionOf(core, RELEASE);
    writeFileSync(file, toPhyphox(motion));
    const code = `import sys; from rimroll.cli import main; sys.exit(main(["gyro", ${JSON.stringify(file)}, "--body", "can_2007", "--json"]))`;
    const found = JSON.parse(await printed(code));
    expect(found.collisions.length).toBeGreaterThanOrEqual(2);
    const first = found.collisions[0];
    const veer = (Math.abs(motion.turns[0]!.angle) * 180) / Math.PI - 180;
    expect(Math.abs(first.veer - veer)).toBeLessThan(Math.max(3 * first.veer_error, 0.1));
    expect(Math.abs(first.friction - 0.2)).toBeLessThan(0.02);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("each ray of the star turns by the angle of turn less a half turn", () => {
  // At a maximum of the tilt the path passes near the middle; halfway down and up the rays are long.
  const motion = motionOf(core, { sideways: 1e-6, duration: 0.5, law: "no_slip" });
  const [turn] = motion.turns;
  const { x, y } = bodyRates(motion.at([turn!.t - 0.02, turn!.t + 0.02]));
  const ways = [Math.atan2(y[0]!, x[0]!), Math.atan2(y[1]!, x[1]!)];
  const veer = Math.abs(turn!.angle) - Math.PI;
  const between = Math.abs(ways[1]! - ways[0]!) % (2 * Math.PI);
  expect(Math.min(between, 2 * Math.PI - between)).toBeCloseTo(veer, 3);
  const star = new Star(motion);
  const points = (path: string) => path.split("L").length;
  expect(star.path()).toMatch(/^M/);
  expect(star.path(turn!.t)).toBe(star.path().slice(0, star.path(turn!.t).length));
  expect(points(star.path(turn!.t))).toBeLessThan(points(star.path()));
  expect(star.path(-1)).toBe("");
  expect(star.largest).toBe(6);
  expect(star.place(star.largest, 0)).toEqual([84, -0]);
});
