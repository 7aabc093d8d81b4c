// The plots: the stretch of time, the moments in it, and their labels.

import { signal } from "@preact/signals-core";
import { beforeAll, describe, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import { countBelow, type Motion } from "../../src/core/motion";
import { sampled, thinned } from "../../src/plots/samples";
import { powersOfTen, powerText, stretchText, tickTexts, timeLabel } from "../../src/plots/ticks";
import { View } from "../../src/plots/view";
import type { Setup } from "../../src/setup/setup";
import { formatDuration, significant } from "../../src/format";
import { loadCore, motionOf as motionFrom } from "../given/core";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

const motionOf = (changes?: Partial<Setup>) => motionFrom(core, changes);

describe("the view", () => {
  test("of a collision holds nine tenths of its turn, counted from its middle", () => {
    const motion = motionOf();
    const view = new View(signal<Motion | undefined>(motion));
    const turn = motion.turns[1]!;
    view.close(turn.t + 0.01);
    const { since, origin, from, to } = view.shown.value;
    expect([since, origin]).toEqual(["collision", turn.t]);
    expect(from).toBeCloseTo(-to, 12);
    const yaw = motion.at([origin + from, origin + to]).column("yaw");
    const part = (yaw[1]! - yaw[0]!) / turn.angle;
    expect(part).toBeGreaterThan(0.9);
    expect(part).toBeLessThan(0.99);
  });

  test("goes with its collision when the set-up changes", () => {
    const motion = signal<Motion | undefined>(motionOf());
    const view = new View(motion);
    view.close(0);
    motion.value = motionOf({ tilt: 25 });
    expect(view.shown.value.origin).toBe(motion.value.turns[0]!.t);
  });

  test("keeps a time in its place as it zooms, and cannot leave the motion", () => {
    const view = new View(signal<Motion | undefined>(motionOf()));
    view.zoom(4, 0.6);
    expect(view.placeOf(0.6)).toBeCloseTo(0.2, 12);
    expect(view.shown.value.to - view.shown.value.from).toBeCloseTo(0.75, 12);
    view.show(-1, 1);
    expect(view.shown.value.from).toBeCloseTo(0, 12);
    expect(view.shown.value.to).toBe(2);
    view.zoom(0.5, 1);
    expect(view.isWhole).toBe(true);
  });

  test("far from any collision counts from a round time, down to a tenth of a nanosecond", () => {
    const view = new View(signal<Motion | undefined>(motionOf()));
    for (let k = 0; k < 60; k++) view.zoom(2, 1.2345678 - view.shown.value.origin);
    const { since, origin, from, to } = view.shown.value;
    expect(since).toBe("time");
    expect(origin).toBeCloseTo(1.2345678, 8);
    expect(to - from).toBeCloseTo(3e-10, 11);
    expect(view.placeOf(1.2345678)).toBeGreaterThan(-1e-3);
    expect(view.placeOf(1.2345678)).toBeLessThan(1.001);
  });
});

describe("the moments of a curve", () => {
  test("are as many as requested in any stretch, in order, and equal the motion", () => {
    const motion = motionOf();
    const { t } = motion.turns[0]!;
    const shown = { since: "collision", origin: t, from: -1e-6, to: 1e-6 } as const;
    const moments = sampled(motion, motion.curve(), shown, 300);
    const times = moments.column("t");
    expect(times.length).toBeGreaterThanOrEqual(300);
    expect([times[0], times.at(-1)]).toEqual([t - 1e-6, t + 1e-6]);
    expect(times.every((time, k) => k === 0 || time >= times[k - 1]!)).toBe(true);
    expect(moments.moment(150)).toEqual(motion.at([times[150]!]).moment(0));
  });

  test("of the whole motion are those of the solver", () => {
    const motion = motionOf();
    const shown = { since: "start", origin: 0, from: 0, to: motion.end } as const;
    expect(sampled(motion, motion.curve(), shown, 300)).toBe(motion.curve());
  });

  test("are counted below a bound", () => {
    expect([0, 1, 1.5, 3, 9].map((bound) => countBelow([1, 2, 3], bound))).toEqual([0, 0, 1, 2, 3]);
  });
});

test("a thinned curve keeps its ends and every extreme, in order", () => {
  const x = Float64Array.from({ length: 30_000 }, (_, k) => k);
  const wave = x.map((k) => Math.sin(k / 1000));
  const spike = x.map((k) => (k === 12_345 ? 7 : k === 23_456 ? -7 : 0));
  const [places, waved, spiked] = thinned(x, [wave, spike], 400) as [number[], number[], number[]];
  expect(places.length).toBeLessThan(6 * 400);
  expect([places[0], places.at(-1)]).toEqual([0, 29_999]);
  expect(places.every((place, k) => k === 0 || place > places[k - 1]!)).toBe(true);
  expect([spiked[places.indexOf(12_345)], spiked[places.indexOf(23_456)]]).toEqual([7, -7]);
  expect(Math.max(...waved)).toBe(Math.max(...wave));
});

describe("in words", () => {
  test("times have the unit that suits them", () => {
    expect([3, 0.0123, 95.2e-6, 4.2e-8, 0].map(formatDuration)).toEqual([
      "3.00\u00a0s",
      "12.3\u00a0ms",
      "95.2\u00a0µs",
      "42.0\u00a0ns",
      "0 s",
    ]);
    expect(significant(-37253.45, 2)).toBe("−37\u202f000");
  });

  test("a stretch says from what it is counted", () => {
    const near = { since: "collision", origin: 0.17640804, from: -1e-4, to: 1e-4 } as const;
    expect(stretchText(near)).toBe(
      "from −100\u00a0µs to 100\u00a0µs about the collision at 0.176408 s",
    );
    expect(timeLabel(near)).toBe("µs from the collision at 0.176408 s");
    expect(timeLabel({ since: "start", origin: 0, from: 0, to: 3 })).toBe("time, s");
  });

  test("labels of an axis have the digits that tell them apart", () => {
    expect(tickTexts([0, 0.5, 1], 1)).toEqual(["0", "0.5", "1.0"]);
    expect(tickTexts([-2.5e-7, 0, 2.5e-7], 1e-6)).toEqual(["−0.25", "0", "0.25"]);
    expect(tickTexts([1000, 2000], 1)).toEqual(["1000", "2000"]);
  });

  test("powers of ten stand apart", () => {
    expect(powersOfTen(-2e5, 2e5, 160)).toEqual([-1e5, -1e3, -10, 0, 10, 1e3, 1e5]);
    expect([-1e5, 1000, 0].map(powerText)).toEqual(["−10⁵", "1000", "0"]);
  });
});
