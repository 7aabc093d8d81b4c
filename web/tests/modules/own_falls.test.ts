// Falls that visitors measured: read, kept in links, pooled, counted and fitted.

import { beforeAll, describe, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import { fitOf, trials } from "../../src/falls/fit";
import { simulateFlicks } from "../../src/falls/flicks";
import {
  fallsFromLink,
  fallsInLink,
  fallsTyped,
  MEASURED,
  tallyOf,
  tallyOfFalls,
} from "../../src/falls/tally";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { fromHash, toHash } from "../../src/setup/url";
import { loadCore } from "../given/core";

test.each([
  ["213 146.5\n218", [213, 146.5, 218]],
  ["213; 146,5; 218°", [213, 146.5, 218]],
  ["213, 146, 218", [213, 146, 218]],
  ["https://lab.example/#tilt=3&falls=213_146.5 http://x.example/?y=1#falls=7", [213, 146.5, 7]],
  ["#falls=213_146.5 12", [213, 146.5, 12]],
])("%s", (text, falls) => {
  expect(fallsTyped(text)).toEqual(falls);
});

test.each(["", "left", "361", "-3", "12 x", "https://lab.example/#tilt=3"])(
  "“%s” has no falls",
  (text) => {
    expect(fallsTyped(text)).toBeUndefined();
  },
);

test("a link holds them", () => {
  const falls = fallsInLink([213, 146.54, 0, 360]);
  expect(falls).toBe("213_146.5_0_360");
  expect(fallsFromLink(falls)).toEqual([213, 146.5, 0, 360]);
  expect(fromHash(`#${toHash({ ...INITIAL, falls })}`).setup.falls).toBe(falls);
  expect(fallsFromLink("")).toEqual([]);
  const many = fallsInLink(new Array(2000).fill(359.9));
  expect(fromHash(`#${toHash({ ...INITIAL, falls: many })}`).refusals).toEqual([]);
  expect(fromHash("#falls=12__3").refusals.map(({ field }) => field)).toEqual(["falls"]);
});

test("directions above 180 are falls to the left, and turns are counted from the lean", () => {
  const { left, right, others } = tallyOfFalls([213, 217, 142]);
  expect([left.count, left.mean, right.count, right.mean, others]).toEqual([
    2,
    expect.closeTo(215, 9),
    1,
    expect.closeTo(218, 9),
    0,
  ]);
});

describe("the friction that fits", () => {
  let core: Core;
  beforeAll(async () => {
    core = await loadCore();
  });
  const flick: Partial<Setup> = { tilt_rate: -5, sideways: 0, law: "coulomb" };

  test.each([0.08, 0.15, 0.25])("is that of simulated falls: %d", (friction) => {
    const setup = { ...INITIAL, ...flick, friction, flicks: 200, seed: 7 };
    const falls = tallyOf(simulateFlicks(core, setup));
    const fit = fitOf([...trials(core, { ...setup, friction: 0.5 }, falls)])!;
    expect(Math.abs(fit.friction - friction)).toBeLessThan(0.03);
    expect(fit.low).toBeLessThanOrEqual(fit.friction);
    expect(fit.high).toBeGreaterThanOrEqual(fit.friction);
    expect(fit.high - fit.low).toBeLessThan(0.1);
  });

  test("of the paper's falls is near that of the likelihood, 0.1", () => {
    const fit = fitOf([...trials(core, { ...INITIAL, ...flick }, MEASURED)])!;
    expect(fit.friction).toBeGreaterThan(0.07);
    expect(fit.friction).toBeLessThan(0.14);
  });

  test("is unknown for a body that cannot be flicked", () => {
    const all = [...trials(core, { ...INITIAL, tilt: 1e-300 }, MEASURED)];
    expect(fitOf(all)).toBeUndefined();
  });
});
