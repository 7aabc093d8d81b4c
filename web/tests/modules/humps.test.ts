// The straight histogram of the story.

import { beforeAll, describe, expect, test } from "vitest";
import type { Core, Theory } from "../../src/core/core";
import { simulateFlicks } from "../../src/falls/flicks";
import { tallyOf } from "../../src/falls/tally";
import { FIELDS } from "../../src/setup/fields";
import { simulationInput } from "../../src/setup/simulation_input";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { binned, binsFor, humps, limitsOf } from "../../src/falls/humps";
import { STEPS } from "../../src/story/steps";
import { loadCore } from "../given/core";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

function theoryOf(setup: Setup): Theory {
  const { body, start, contactLaw, options } = simulationInput(core, setup);
  return core.theory(body, start, contactLaw, options.gravity);
}

function shownFor(changed: Partial<Setup>) {
  const setup = { ...INITIAL, ...changed };
  const theory = theoryOf(setup);
  const tally = tallyOf(simulateFlicks(core, setup));
  const turns = [...tally.left.turns, ...tally.right.turns];
  const bins = binsFor(theory, turns);
  return { theory, tally, turns, bins };
}

const FRICTION = STEPS.find(({ title }) => title === "Friction")!.setup;

test("the axis of the paper's can goes from 195° to 230° in bars of 1°", () => {
  expect(shownFor(FRICTION).bins).toEqual({ from: 195, to: 230, width: 1 });
  expect(binsFor(theoryOf(INITIAL), [])).toEqual({ from: 195, to: 230, width: 1 });
});

const BODIES = Object.keys(FIELDS.body.choices) as Setup["body"][];

test.each(BODIES)("%s has its limits and nearly all of its falls on the axis", (body) => {
  for (const law of ["coulomb", "frictionless", "no_slip"] as const)
    for (const twist of [0, 1]) {
      const { theory, turns, bins } = shownFor({ ...FRICTION, body, law, twist, tilt: 10 });
      for (const limit of limitsOf(theory)) {
        expect(limit).toBeGreaterThan(bins.from);
        expect(limit).toBeLessThan(bins.to);
      }
      const { below, bins: all, above } = binned(turns, bins);
      expect(all.length).toBe((bins.to - bins.from) / bins.width);
      expect(all.length).toBeLessThanOrEqual(60);
      expect(below + above).toBeLessThanOrEqual(0.1 * turns.length);
      expect(below + above + all.reduce((sum, count) => sum + count, 0)).toBe(turns.length);
    }
});

test("what lies beyond the ends is binned there, and hides nothing else", () => {
  const bins = binsFor(theoryOf(INITIAL), [...new Array<number>(40).fill(210), 3, 900]);
  expect(bins).toEqual({ from: 195, to: 230, width: 1 });
  expect(binned([3, 194.999, 195, 229.999, 230, 900], bins)).toMatchObject({ below: 2, above: 2 });
});

describe("the picture", () => {
  const bars = (svg: string, side: string) =>
    [...svg.matchAll(new RegExp(`class="bar ${side}" x="([\\d.]+)" y="([\\d.]+)"`, "g"))].map(
      ([, x, y]) => ({ x: Number(x), y: Number(y) }),
    );

  test("has the humps of both sides, above and below the axis, where the falls are", () => {
    const { theory, tally, bins } = shownFor(FRICTION);
    const svg = humps({ tally, theory, bins, measured: true });
    const [left, right] = [bars(svg, "left"), bars(svg, "right")];
    for (const [drawn, side] of [
      [left, tally.left],
      [right, tally.right],
    ] as const) {
      const apart = new Set(side.turns.map(Math.floor));
      expect(drawn.length).toBe(apart.size);
      expect(drawn.length).toBeGreaterThan(3);
    }
    expect(Math.max(...left.map(({ y }) => y))).toBeLessThan(Math.min(...right.map(({ y }) => y)));
    expect(svg).toContain("no slip 202.3°");
    expect(svg).toContain("no friction 221.0°");
    expect(svg.match(/class="measured"/g)).toHaveLength(2);
  });

  test("is mirrored for a hand that errs to the other side", () => {
    const setup = { ...FRICTION, unsteadiness: 0, flicks: 1 };
    const one = shownFor({ ...setup, sideways: 0.02 });
    const other = shownFor({ ...setup, sideways: -0.02 });
    expect([one.tally.left.count, other.tally.right.count]).toEqual([1, 1]);
    expect(other.tally.right.turns[0]).toBeCloseTo(one.tally.left.turns[0]!, 9);
    expect(other.bins).toEqual(one.bins);
  });

  test("of another body has no measurements of the paper", () => {
    const { theory, tally, bins } = shownFor({ body: "coin" });
    const svg = humps({ tally, theory, bins, measured: false });
    expect(svg).not.toContain("measured");
    expect(svg).not.toContain("NaN");
  });
});
