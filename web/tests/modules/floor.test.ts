// A floor that moves: records of a hand, the picture, words, and what the lab computes.

import { beforeAll, describe, expect, test } from "vitest";
import { Clock } from "../../src/clock";
import type { Core } from "../../src/core/core";
import type { Motion } from "../../src/core/motion";
import { follower, type ShakenCore, shakerWith } from "../../src/floor/floor";
import { MAX_SAMPLES, recordFrom, recordOf, STEP } from "../../src/floor/ground";
import type { Shaking } from "../../src/floor/shaking";
import { toCsv } from "../../src/setup/export";
import { FIELDS } from "../../src/setup/fields";
import { INITIAL, read, type Setup } from "../../src/setup/setup";
import { signal } from "@preact/signals-core";
import { loadCore, loadShakenCore, shakenInput } from "../given/core";
import { labWith } from "../given/page";

let core: Core;
let shaken: ShakenCore;
beforeAll(async () => {
  [core, shaken] = [await loadCore(), await loadShakenCore()];
});

function shaking(changes: Partial<Setup>): { motion: Motion; shaking: Shaking; setup: Setup } {
  const setup: Setup = { ...INITIAL, floor: "pulse", body: "soda_can", ...changes };
  const input = shakenInput(shaken, setup);
  const its = input.shaking as Shaking;
  return { motion: its.simulation(input).now(), shaking: its, setup };
}

/** A hand that swings and comes to rest aside. */
const PATH = Array.from({ length: 90 }, (_, k) => ({
  x: 0.05 * Math.sin(0.2 * k) + 0.001 * k,
  y: -0.0005 * k,
  t: 5 + k / 60,
}));

describe("a record of a hand", () => {
  test("moves the table to where the hand went, and leaves it at rest", () => {
    const { step, samples } = recordFrom(recordOf(PATH));
    const [first, last] = [PATH[0]!, PATH.at(-1)!];
    for (const [axis, went] of [
      [0, last.x - first.x],
      [1, last.y - first.y],
    ] as const) {
      let [velocity, place] = [0, 0];
      samples.slice(1).forEach((after, k) => {
        const [a, b] = [samples[k]![axis], after[axis]];
        place += step * (velocity + (step * (2 * a + b)) / 6);
        velocity += (step * (a + b)) / 2;
      });
      expect(Math.abs(velocity)).toBeLessThan(3e-4);
      expect(place).toBeCloseTo(went, 3);
    }
  });

  test("is a text that the page reads, of limited length", () => {
    const long = PATH.map(({ x, y, t }) => ({ x: 100 * x, y, t: 20 * t }));
    for (const path of [PATH, long, []]) {
      const record = recordOf(path);
      expect(read("record", record)).toEqual({ value: record });
      expect(record.length).toBeLessThanOrEqual(4 * MAX_SAMPLES);
      for (const sample of recordFrom(record).samples)
        for (const value of sample) expect(Math.abs(value)).toBeLessThanOrEqual(20.48);
    }
    expect(recordFrom("")).toEqual({
      step: STEP,
      samples: [
        [0, 0, 0],
        [0, 0, 0],
      ],
    });
  });
});

test("the table moves by the closed form of a sine", () => {
  const { shaking: its } = shaking({ shake: 3, period: 0.4, cycles: 1, vertical: -1 });
  const { ground_acceleration_x, ground_displacement_x, ground_displacement_z } = its.at([0.1, 2]);
  expect(ground_acceleration_x[0]).toBeCloseTo(3, 12);
  const rate = (2 * Math.PI) / 0.4;
  expect(ground_displacement_x[0]).toBeCloseTo((3 * (0.1 - 1 / rate)) / rate, 12);
  // After a whole sine the velocity is zero.
  expect(ground_displacement_x[1]).toBeCloseTo((3 * 0.4) / rate, 12);
  expect(ground_displacement_z[1]).toBeCloseTo((-1 * 0.4) / rate, 12);
});

test("the camera follows a table that moves away, and the room stands still", () => {
  const { shaking: its } = shaking({ pulse: "half_sine", shake: 10, period: 0.2 });
  const at = follower((times) => its.at(times), 3, 0.05);
  for (const t of [0, 0.05, 0.15, 1, 2.9]) {
    const { table, camera } = at(t);
    expect(Math.hypot(table.x, table.y, table.z)).toBeLessThanOrEqual(0.05 + 1e-12);
    expect(table.x + camera.x).toBeCloseTo(its.at([t]).ground_displacement_x[0]!, 5);
  }
  expect(at(0.02).camera.x).toBe(0);
  expect(at(2).table.x).toBeCloseTo(0.05, 6);
});

describe("in words", () => {
  const words = (changes: Partial<Setup>) => {
    const { motion, shaking: its, setup } = shaking(changes);
    const { said, ended, lowest, then } = its.verdict(motion, 0.4358, setup);
    return { text: `${said} ${ended}`, lowest, then };
  };

  test("a can that stands is lifted and overturns", () => {
    const { text, lowest, then } = words({ start: "standing" });
    expect(text).toMatch(
      /^The floor moves by up to 3\d cm and accelerates at up to 8\.0 m\/s²\. The can begins to rock at [\d.]+\sms \(uplift\)\. Its largest tilt is 90\.0°\. The can overturns at [\d.]+\sms\.$/,
    );
    expect(lowest).toMatchObject({ name: "Largest tilt", number: "90.0°" });
    expect(then?.name).toBe("Uplift");
  });

  test("a weak pulse does not lift it", () => {
    const { text, then } = words({ start: "standing", shake: 2 });
    expect(text).toContain("The can stands still on the floor and never begins to rock.");
    expect(text).toContain("It does not overturn. It stands flat after 3.00\u00a0s");
    expect(then?.number).toBe("–");
  });

  test("on little friction it slides", () => {
    expect(words({ start: "standing", friction: 0.2 }).text).toContain(
      "The can slides on its base and never begins to rock.",
    );
  });

  test("a flat landing that ends the motion is named", () => {
    const { text } = words({ start: "standing", shake: 5, flat: "stop" });
    expect(text).toContain("The base comes down flat");
  });

  test("a floor without acceleration does not move", () => {
    expect(words({ shake: 0 }).text).toMatch(/^The floor does not move\. The can leans at first\./);
  });
});

test.each(Object.keys(FIELDS.flat.choices) as Setup["flat"][])(
  "after the flat landing “%s” the motion goes on unless it should end",
  (flat) => {
    const { motion } = shaking({ start: "standing", shake: 5, flat });
    expect(motion.status === "face_down").toBe(flat === "stop");
  },
);

test("a jump of the contact point takes no time of the visitor", () => {
  const { motion } = shaking({ start: "standing", shake: 5, flat: "housner", duration: 0.27 });
  const yaw = motion.samples(1).column("yaw");
  expect(Math.max(...yaw) - Math.min(...yaw)).toBeGreaterThan(Math.PI - 0.01);
  const clock = new Clock(signal<Motion | undefined>(motion));
  // In the plane of the pulse the contact point only jumps, so that nothing is slowed down.
  expect(clock.progressAt(motion.end / 2)).toBeCloseTo(0.5, 6);
});

test("the lab waits for what shakes the floor, and computes with it from then on", () => {
  const lab = labWith(core, { floor: "pulse", start: "standing", body: "soda_can" });
  expect(lab.outcome.value).toEqual({
    refused: "the part of this page that shakes the floor is being loaded",
  });
  lab.shaker.value = shakerWith(shaken);
  expect(lab.motion.value?.events[0]?.kind).toBe("uplift");
  expect(lab.shaking.value).toBeDefined();
  lab.change({ floor: "rest" });
  expect(lab.shaking.value).toBe(undefined);
  expect(lab.motion.value?.at([0]).moment(0).tilt).toBeGreaterThan(0.3);
});

test("a file of the numbers has the motion of the table", () => {
  const { motion, shaking: its } = shaking({ start: "standing", duration: 0.4 });
  const [head = "", ...rows] = toCsv(motion, its).trimEnd().split("\n");
  const names = head.split(",");
  expect(names.slice(-6)).toEqual(Object.keys(its.at([0])));
  const cells = rows.map((row) => row.split(",").map(Number));
  const t = cells.map((row) => row[0] as number);
  const place = names.indexOf("ground_displacement_x");
  expect(cells.map((row) => row[place])).toEqual([...its.at(t).ground_displacement_x]);
});
