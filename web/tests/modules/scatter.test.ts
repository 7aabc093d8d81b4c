import { beforeAll, describe, expect, test } from "vitest";
import type { Core, State } from "../../src/core/core";
import { scatteredStarts, simulateFlicks, spreads } from "../../src/falls/flicks";
import { bodyOf, startOf } from "../../src/setup/simulation_input";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { loadCore } from "../given/core";
import { printed } from "../given/python";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

const flick: Setup = { ...INITIAL, tilt: 20, tilt_rate: -4, sideways: 0, flicks: 1000 };
const starts = (changed: Partial<Setup> = {}): State[] => {
  const setup = { ...flick, ...changed };
  return scatteredStarts(setup, bodyOf(core, setup));
};

const mean = (values: number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
const spread = (values: number[]) => {
  const middle = mean(values);
  return Math.sqrt(mean(values.map((value) => (value - middle) ** 2)));
};
const sideways = ({ spinRate, tilt }: State) => -spinRate * Math.sin(tilt);
const twist = ({ yawRate, spinRate, tilt }: State) => yawRate + spinRate * Math.cos(tilt);

describe("a thousand flicks of an unsteady hand", () => {
  // Bounds are 4.5 standard errors, σ/√1000 for a mean and σ/√2000 for a standard deviation.
  const near = (values: number[], middle: number, deviation: number) => {
    expect(Math.abs(mean(values) - middle)).toBeLessThan((4.5 * deviation) / Math.sqrt(1000));
    expect(Math.abs(spread(values) / deviation - 1)).toBeLessThan(4.5 / Math.sqrt(2000));
  };

  test("scatter about the set-up as rimroll.Release does", () => {
    const made = starts();
    const tilt = (20 * Math.PI) / 180;
    near(made.map((start) => start.tilt), tilt, 0.1 * tilt); // prettier-ignore
    near(made.map((start) => start.tiltRate), -4, 0.07 * 4); // prettier-ignore
    near(made.map(sideways), 0, 0.05 * 4);
    near(made.map(twist), 0, 0.05 * 4);
  });

  test("scatter half as much from a hand half as unsteady", () => {
    near(starts({ unsteadiness: 50 }).map(sideways), 0, 0.1);
  });

  test("scatter at least by 0.002 √(g/R) when the body is let go at rest", () => {
    const { radius } = core.preset("can_2007");
    near(starts({ tilt_rate: 0 }).map(sideways), 0, 0.002 * Math.sqrt(flick.gravity / radius));
  });
});

describe("the spreads of an unsteady hand are those of rimroll.Release", async () => {
  const names = ["can_2007", "coin"] as const; // flicks of slender bodies are too slow
  const found: Record<string, Record<"flick" | "let go", Record<string, number>>> = JSON.parse(
    await printed(`
import json
import rimroll as rr

bodies = [rr.bodies.by_name(name) for name in ${JSON.stringify(names)}]
hands = [
    {hand: rr.Release.named(hand, body).parameters() for hand in ("flick", "let go")}
    for body in bodies
]
print(json.dumps(dict(zip(${JSON.stringify(names)}, hands))))
`),
  );
  const degrees = 180 / Math.PI;

  test.each(names)("%s", (name) => {
    for (const hand of ["flick", "let go"] as const) {
      const release = found[name]?.[hand] as Record<string, number>;
      const value = (field: string) => release[`release_${field}`] as number;
      const setup = { ...flick, tilt: degrees * value("tilt"), tilt_rate: value("tilt_rate") };
      const spread = spreads(setup, core.preset(name));
      for (const field of ["tilt_rate", "sideways", "twist"] as const)
        expect(spread[field]).toBeCloseTo(value(`${field}_spread`), 12);
      if (hand === "flick") expect(spread.tilt).toBeCloseTo(degrees * value("tilt_spread"), 12);
    }
  });
});

test("a steady hand repeats the release to the last bit", () => {
  for (const start of starts({ unsteadiness: 0, flicks: 5 })) expect(start).toEqual(startOf(flick));
});

test("the same seed scatters in the same way, another one differently", () => {
  expect(starts({ seed: 7 })).toEqual(starts({ seed: 7 }));
  expect(starts({ seed: 7 })).not.toEqual(starts({ seed: 8 }));
});

test("more flicks begin with the fewer", () => {
  expect(starts({ flicks: 50 }).slice(0, 42)).toEqual(starts({ flicks: 42 }));
});

test("no flick begins upright or on the side", () => {
  for (const tilt of [0.001, 45, 89.9])
    for (const start of starts({ tilt, unsteadiness: 1000 })) {
      expect(start.tilt).toBeGreaterThan(0);
      expect(start.tilt).toBeLessThan(
        Math.max((89.5 * Math.PI) / 180, (tilt * Math.PI) / 180 + 1e-9),
      );
    }
});

describe("forty-two flicks that topple the can", () => {
  test("fall in two humps about the opposite side, none between them", () => {
    const falls = simulateFlicks(core, { ...flick, flicks: 42, tilt_rate: -5.5, law: "no_slip" });
    const fell = falls.filter(({ outcome }) => outcome === "toppled");
    expect(fell.length).toBeGreaterThan(30);
    const degrees = fell.map(({ direction }) => (direction * 180) / Math.PI - 180);
    expect(degrees.every((aside) => Math.abs(aside) > 10 && Math.abs(aside) < 60)).toBe(true);
    expect(degrees.some((aside) => aside > 0) && degrees.some((aside) => aside < 0)).toBe(true);
  });

  test("fall nowhere when the set-up is refused", () => {
    expect(simulateFlicks(core, { ...flick, tilt: 1e-300, tilt_rate: 0 })).toEqual([]);
  });
});
