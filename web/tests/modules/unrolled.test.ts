// The rim and the table unrolled, and the magnified gap.

import { beforeAll, describe, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import { fadeOf, gapOf, magnification, Path } from "../../src/scene/closeup";
import { formatSmall } from "../../src/scene/measures";
import { simulationInput } from "../../src/setup/simulation_input";
import type { Setup } from "../../src/setup/setup";
import { loadCore } from "../given/core";
import { labWith } from "../given/page";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

/** The runs in the first turn, and the length of the contact point's path on the table. */
function runsOf(changed: Partial<Setup>) {
  const lab = labWith(core, changed);
  const motion = lab.motion.value!;
  const { radius } = simulationInput(core, lab.setup.value).body;
  const end = motion.turns[0]!.end;
  const times = Float64Array.from({ length: 200_000 }, (_, k) => (end * k) / 199_999);
  const [x, y] = (["contact_x", "contact_y"] as const).map((name) => motion.at(times).column(name));
  let path = 0;
  for (let k = 1; k < times.length; k++)
    path += Math.hypot(x![k]! - x![k - 1]!, y![k]! - y![k - 1]!);
  return {
    radius,
    path,
    turn: motion.turns[0]!.angle,
    ...new Path(motion, radius).between(0, end),
  };
}

describe("the contact point runs", () => {
  test.each([0.1, -0.1])(
    "as far along the rim as along the table where it rolls (%d)",
    (sideways) => {
      const { rim, table, slip, path, radius, turn } = runsOf({ law: "no_slip", sideways });
      expect(slip).toBeLessThan(1e-9 * radius);
      expect(table).toBeCloseTo(rim, 12);
      expect(Math.sign(table)).toBe(Math.sign(turn));
      // Chords of the path, which is round.
      expect(Math.abs(table)).toBeCloseTo(path, 5);
      // The body itself hardly turns.
      expect(Math.abs(rim / radius / turn - 1)).toBeLessThan(0.01);
    },
  );

  test("as far along the table as its path is long, less what it slips across, where it slides", () => {
    const { rim, table, slip, path } = runsOf({ law: "frictionless", sideways: 0.1 });
    expect(slip).toBeGreaterThan(0.005);
    expect(table).not.toBeCloseTo(rim, 4);
    expect(table).toBeLessThan(path);
    expect(path).toBeLessThan(table + slip);
  });
});

describe("the gap", () => {
  test.each([
    [2e-5, 10_000],
    [0.002, 100],
    [0.08, 2],
    [1, 1],
    [undefined, 1],
  ])("at a smallest tilt of %d is drawn %d times as high", (minTilt, times) => {
    const radius = 0.05;
    expect(magnification(minTilt, radius)).toBe(times);
    if (times === 1) return;
    const height = times * 2 * radius * Math.sin(minTilt!);
    expect(height).toBeGreaterThan(0.15 * radius);
    expect(height).toBeLessThanOrEqual(0.5 * radius);
    expect(fadeOf(height, radius)).toBe(1);
    expect(fadeOf(10 * height, radius)).toBeLessThan(1);
  });

  test("is that of the highest point of the rim", () => {
    // A base whose lowest point touches the table.
    expect(gapOf({ tilt: 0.1, z: 0.05 * Math.sin(0.1) }, 0.05)).toBeCloseTo(
      0.1 * Math.sin(0.1),
      15,
    );
  });

  test.each([
    [0, "0\u00a0cm"],
    [3.49e-6, "3.5\u00a0µm"],
    [1.44e-4, "140\u00a0µm"],
    [0.0123, "1.2\u00a0cm"],
    [0.116, "11.6\u00a0cm"],
  ])("of %d m is written as %s", (length, text) => {
    expect(formatSmall(length)).toBe(text);
  });
});
