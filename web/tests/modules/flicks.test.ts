// Many flicks: how they are made one after the other, counted, and told.

import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from "vitest";
import type { Core } from "../../src/core/core";
import { clearThem, makeThem } from "../../src/falls/making";
import { flicked } from "../../src/falls/flicked";
import { tallied } from "../../src/falls/tally";
import { told } from "../../src/falls/told";
import { posed } from "../../src/setup/posed";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { loadCore } from "../given/core";
import { labWith } from "../given/page";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

const DEGREES = 180 / Math.PI;

function tallyOf(changed: Partial<Setup>) {
  const setup = { ...INITIAL, ...changed };
  const { body, start, surface, options } = posed(core, setup);
  const limit = core.theory(body, start, surface, options.gravity).here * DEGREES;
  return { ...tallied(flicked(core, setup)), limit };
}

describe("how far round", () => {
  test("a coin goes more than once, as its theory says", () => {
    const { word, left, right, limit, directions } = tallyOf({ body: "coin" });
    expect(word).toBe("rocked");
    expect(limit).toBeCloseTo(393.75, 2);
    expect(Math.abs(left.mean - limit)).toBeLessThan(2);
    expect(Math.abs(right.mean - limit)).toBeLessThan(2);
    expect(left.deviation).toBeLessThan(2);
    // The dots lie where it came up: 33.75° to either side of where it leaned at first.
    for (const direction of directions)
      expect(Math.abs(Math.min(direction, 360 - direction) - 33.75)).toBeLessThan(5);
  });

  test("a can that falls lies where it came to by going round so far", () => {
    const setup = { ...INITIAL, tilt_rate: -5, law: "no_slip" } as const;
    const falls = flicked(core, setup).filter(({ outcome }) => outcome === "toppled");
    expect(falls.length).toBeGreaterThan(30);
    for (const { turn, direction } of falls) {
      expect(Math.cos(turn - direction)).toBeCloseTo(1, 9);
      expect(Math.abs(turn) * DEGREES).toBeGreaterThan(190);
    }
    const { left, right } = tallied(falls);
    expect(left.count).toBe(falls.filter(({ turn }) => turn > 0).length);
    expect(left.count + right.count).toBe(falls.length);
  });

  test("one that rises first turns from where it was highest", () => {
    const setup = { ...INITIAL, tilt_rate: 0.5, unsteady: 0, flicks: 1, law: "no_slip" } as const;
    const [flick] = flicked(core, setup);
    const { body, start, surface, options } = posed(core, setup);
    const motion = core.simulate(body, start, surface, options);
    const turn = motion.turns.find(({ minTilt }) => minTilt < 0.01);
    expect(flick?.turn).toBeCloseTo(turn?.angle ?? NaN, 4);
    motion.forget();
  });
});

describe("made one after the other", () => {
  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  const flick = { tilt_rate: -5, flicks: 10 };

  test("they are told when all of them are there", () => {
    const lab = labWith(core, flick);
    expect(told(lab)).toBe("");
    makeThem(lab);
    expect(lab.making.value).toBe(true);
    vi.advanceTimersByTime(600);
    expect(lab.flicksMade.value).toBeGreaterThan(1);
    expect(lab.flicksMade.value).toBeLessThan(10);
    expect(told(lab)).toBe("Flicking it …");
    vi.advanceTimersByTime(2000);
    expect([lab.making.value, lab.flicksMade.value]).toEqual([false, 10]);
    expect(told(lab)).toMatch(/^Of 10 flicks \d fell to the left after 2\d\d\.\d°/);
    clearThem(lab);
    expect(told(lab)).toBe("");
  });

  test("all at once for who wants no motion", () => {
    const lab = labWith(core, flick, true);
    makeThem(lab);
    expect([lab.making.value, lab.flicksMade.value]).toEqual([false, 10]);
  });

  test("a clear on the way ends it", () => {
    const lab = labWith(core, flick);
    makeThem(lab);
    vi.advanceTimersByTime(600);
    clearThem(lab);
    vi.advanceTimersByTime(5000);
    expect([lab.making.value, lab.flicksMade.value]).toEqual([false, undefined]);
  });

  test("a set-up that cannot be flicked says so until it is mended", () => {
    const lab = labWith(core, { ...flick, tilt: 1e-300 });
    makeThem(lab);
    expect(told(lab)).toBe("This set-up cannot be flicked.");
    lab.change({ tilt: 20 });
    expect(told(lab)).toMatch(/^Of 10 flicks .* fell/);
  });

  test("the words are of the flicks that are shown, whatever is changed", () => {
    const lab = labWith(core, flick, true);
    makeThem(lab);
    lab.change({ flicks: 40 });
    const before = told(lab);
    expect(before).toMatch(/^Of 10 flicks/);
    lab.change({ law: "frictionless" });
    expect(told(lab)).toMatch(/^Of 10 flicks/);
    expect(told(lab)).not.toBe(before);
    lab.change({ flicks: 4 });
    expect(lab.flicksMade.value).toBe(4);
    lab.change({ flicks: 40 });
    expect(told(lab)).toMatch(/^Of 4 flicks/);
  });

  test("they are computed once, not again for each that is shown", () => {
    const lab = labWith(core, flick);
    const falls = vi.spyOn(core, "falls");
    makeThem(lab);
    vi.advanceTimersByTime(5000);
    expect(lab.flicks.value.length).toBe(10);
    expect(falls).toHaveBeenCalledTimes(1);
    falls.mockRestore();
  });
});
