// Many flicks: their animation, tally and summary.

import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from "vitest";
import type { Core } from "../../src/core/core";
import { clearFlicks, flickSummary, startFlicks } from "../../src/falls/shown";
import { simulateFlicks } from "../../src/falls/flicks";
import { tallyOf } from "../../src/falls/tally";
import { simulationInput } from "../../src/setup/simulation_input";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { loadCore } from "../given/core";
import { labWith } from "../given/page";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

const DEGREES = 180 / Math.PI;

function tallyFor(changed: Partial<Setup>) {
  const setup = { ...INITIAL, ...changed };
  const { body, start, contactLaw, options } = simulationInput(core, setup);
  const limit = core.theory(body, start, contactLaw, options.gravity).here * DEGREES;
  return { ...tallyOf(simulateFlicks(core, setup)), limit };
}

describe("angles of turn", () => {
  test("of a coin exceed 360°, as in theory", () => {
    const { outcome, left, right, limit, directions } = tallyFor({ body: "coin" });
    expect(outcome).toBe("rocked");
    expect(limit).toBeCloseTo(393.75, 2);
    expect(Math.abs(left.mean - limit)).toBeLessThan(2);
    expect(Math.abs(right.mean - limit)).toBeLessThan(2);
    expect(left.deviation).toBeLessThan(2);
    // The coin comes up 33.75° to either side of its initial lean.
    for (const direction of directions)
      expect(Math.abs(Math.min(direction, 360 - direction) - 33.75)).toBeLessThan(5);
  });

  test("of a can that falls agree with its direction of fall", () => {
    const setup = { ...INITIAL, tilt_rate: -5, law: "no_slip" } as const;
    const falls = simulateFlicks(core, setup).filter(({ outcome }) => outcome === "toppled");
    expect(falls.length).toBeGreaterThan(30);
    for (const { turn, direction } of falls) {
      expect(Math.cos(turn - direction)).toBeCloseTo(1, 9);
      expect(Math.abs(turn) * DEGREES).toBeGreaterThan(190);
    }
    const { left, right } = tallyOf(falls);
    expect(left.count).toBe(falls.filter(({ turn }) => turn > 0).length);
    expect(left.count + right.count).toBe(falls.length);
  });

  test("start at the tilt maximum if the body rises first", () => {
    const setup = {
      ...INITIAL,
      tilt_rate: 0.5,
      unsteadiness: 0,
      flicks: 1,
      law: "no_slip",
    } as const;
    const [flick] = simulateFlicks(core, setup);
    const { body, start, contactLaw, options } = simulationInput(core, setup);
    const motion = core.simulate(body, start, contactLaw, options);
    const turn = motion.turns.find(({ minTilt }) => minTilt < 0.01);
    expect(flick?.turn).toBeCloseTo(turn?.angle ?? NaN, 4);
    motion.forget();
  });
});

describe("one after the other", () => {
  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  const flick = { tilt_rate: -5, flicks: 10 };

  test("flicks are summarised when all of them are shown", () => {
    const lab = labWith(core, flick);
    expect(flickSummary(lab)).toBe("");
    startFlicks(lab);
    expect(lab.flicking.value).toBe(true);
    vi.advanceTimersByTime(600);
    expect(lab.flicksShown.value).toBeGreaterThan(1);
    expect(lab.flicksShown.value).toBeLessThan(10);
    expect(flickSummary(lab)).toBe("Flicking it …");
    vi.advanceTimersByTime(2000);
    expect([lab.flicking.value, lab.flicksShown.value]).toEqual([false, 10]);
    expect(flickSummary(lab)).toMatch(/^Of 10 flicks, \d fell to the left after 2\d\d\.\d°/);
    clearFlicks(lab);
    expect(flickSummary(lab)).toBe("");
  });

  test("flicks are shown at once with reduced motion", () => {
    const lab = labWith(core, flick, true);
    startFlicks(lab);
    expect([lab.flicking.value, lab.flicksShown.value]).toEqual([false, 10]);
  });

  test("clearing the flicks ends the animation", () => {
    const lab = labWith(core, flick);
    startFlicks(lab);
    vi.advanceTimersByTime(600);
    clearFlicks(lab);
    vi.advanceTimersByTime(5000);
    expect([lab.flicking.value, lab.flicksShown.value]).toEqual([false, undefined]);
  });

  test("a set-up that cannot be flicked says so until it is corrected", () => {
    const lab = labWith(core, { ...flick, tilt: 1e-300 });
    startFlicks(lab);
    expect(flickSummary(lab)).toBe("This set-up cannot be flicked.");
    lab.change({ tilt: 20 });
    expect(flickSummary(lab)).toMatch(/^Of 10 flicks, .* fell/);
  });

  test("the summary covers the flicks that are shown, after every change", () => {
    const lab = labWith(core, flick, true);
    startFlicks(lab);
    lab.change({ flicks: 40 });
    const before = flickSummary(lab);
    expect(before).toMatch(/^Of 10 flicks/);
    lab.change({ law: "frictionless" });
    expect(flickSummary(lab)).toMatch(/^Of 10 flicks/);
    expect(flickSummary(lab)).not.toBe(before);
    lab.change({ flicks: 4 });
    expect(lab.flicksShown.value).toBe(4);
    lab.change({ flicks: 40 });
    expect(flickSummary(lab)).toMatch(/^Of 4 flicks/);
  });

  test("flicks are computed once, not again for each one shown", () => {
    const lab = labWith(core, flick);
    const falls = vi.spyOn(core, "falls");
    startFlicks(lab);
    vi.advanceTimersByTime(5000);
    expect(lab.flicks.value.length).toBe(10);
    const made = falls.mock.calls.flatMap(([, , , trials]) => trials);
    expect(made.length).toBe(10);
    falls.mockRestore();
  });
});
