// Two motions on one clock: which ones, what is compared, and how a link holds them.

import { beforeAll, describe, expect, test } from "vitest";
import { Clock, MAX_CONTACT_RATE } from "../../src/clock";
import { dashesAlong, dashesUntil, isBeside, layoutOf } from "../../src/compare/ghost";
import { numberRows, numbersOf, setupRows } from "../../src/compare/table";
import { PRESETS } from "../../src/compare/section";
import type { Core } from "../../src/core/core";
import { joined } from "../../src/plots/samples";
import { sizeOf } from "../../src/scene/bodies/shapes";
import { MOTION_FIELDS } from "../../src/setup/fields";
import { hashOf, readLink } from "../../src/setup/address";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { fromHash, toHash } from "../../src/setup/url";
import { Chance } from "../given/chance";
import { loadCore, motionOf } from "../given/core";
import { labWith } from "../given/page";
import { anySetup } from "../given/setups";
import { signal } from "@preact/signals-core";
import type { Motion } from "../../src/core/motion";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

/** A lab that compares a pair. */
function comparing(name: keyof typeof PRESETS, setup: Partial<Setup> = {}) {
  const lab = labWith(core, setup);
  const { part, other } = PRESETS[name](lab.setup.value);
  lab.compare(other, part);
  lab.complete();
  return lab;
}

const hand = { sideways: 0.02, duration: 1 };

describe("the pairs", () => {
  test("on ice the rim slips and comes up near the limit of no friction, on rubber it rolls", () => {
    const lab = comparing("ice");
    const [ice, rubber] = [lab.outcome.value, lab.other.outcome.value].map(numbersOf);
    const { noSlip, frictionless } = lab.theory.value!;
    expect(Math.abs(ice!.turn - frictionless)).toBeLessThan(0.04);
    expect(Math.abs(rubber!.turn - noSlip)).toBeLessThan(0.04);
    const kinds = (motion: Motion) => new Set(motion.phases.map(({ kind }) => kind));
    expect(kinds(lab.motion.value!)).toContain("sliding");
    expect(kinds(lab.other.motion.value!)).toEqual(new Set(["rolling"]));
  });

  test("can and coin differ in the body alone", () => {
    const lab = comparing("coin", { tilt: 35, law: "no_slip" });
    expect(setupRows(lab.setup.value, lab.otherSetup.value!)).toEqual([
      { name: "Body", a: "The paper's can", b: "Coin (1 euro)", difference: "" },
    ]);
  });

  test("a start and its mirror turn by opposite angles", () => {
    const lab = comparing("mirror", { ...hand, twist: 0.1, yaw: 30 });
    const [mine, other] = [lab.motion.value!, lab.other.motion.value!];
    expect(other.turns[0]!.angle).toBeCloseTo(-mine.turns[0]!.angle, 9);
    expect(other.turns[0]!.t).toBeCloseTo(mine.turns[0]!.t, 9);
  });

  test("a motion that is kept stays while the set-up changes, and both can be undone", () => {
    const lab = comparing("keep", hand);
    const kept = lab.other.motion.value!.turns[0]!.angle;
    expect(lab.motion.value!.turns[0]!.angle).toBe(kept);
    lab.change({ tilt: 10 });
    expect(lab.other.motion.value!.turns[0]!.angle).toBe(kept);
    expect(lab.motion.value!.turns[0]!.angle).not.toBe(kept);
    lab.undo();
    expect([lab.setup.value.tilt, lab.otherSetup.value?.tilt]).toEqual([20, 20]);
    lab.undo();
    expect(lab.otherSetup.value).toBe(undefined);
  });
});

describe("the numbers", () => {
  test("of a motion without losses keep all energy, and otherwise lose what resistance takes", () => {
    const lab = labWith(core, { ...hand, law: "no_slip" });
    expect(numbersOf(lab.outcome.value)!.energy).toBeCloseTo(1, 9);
    lab.change({ rolling: 1e-4 });
    const motion = lab.motion.value!;
    const [start, end] = [0, motion.turns[0]!.end].map((time) => motion.at([time]).moment(0));
    const lost = end!.resistance_loss / (start!.kinetic_energy + start!.potential_energy);
    expect(lost).toBeGreaterThan(1e-5);
    expect(numbersOf(lab.outcome.value)!.energy).toBeCloseTo(1 - lost, 9);
  });

  test("differ as a reader would subtract and divide them", () => {
    const some = numbersOf(labWith(core, hand).outcome.value)!;
    const degrees = Math.PI / 180;
    const a = { ...some, turn: 202.26 * degrees, time: 0.1, energy: 1 };
    const b = { ...some, turn: 203.94 * degrees, time: 0.25, energy: 0.95 };
    const rows = new Map(numberRows(a, b).map((row) => [row.name, row]));
    expect(rows.get("Contact ran round")).toMatchObject({
      a: "202.3°",
      b: "203.9°",
      difference: "+1.6°",
    });
    expect(rows.get("Time until then")!.difference).toBe("× 2.5");
    expect(rows.get("Energy kept")!.difference).toBe("−5.0\u00a0%");
  });

  test("of a body that does not come down are not there", () => {
    const lab = labWith(core, { tilt: 80 });
    const rows = numberRows(numbersOf(lab.outcome.value), numbersOf(lab.outcome.value));
    expect(rows.map(({ name }) => name)).not.toContain("Contact ran round");
  });

  test("fields that neither motion depends on are not compared", () => {
    const a = { ...INITIAL, law: "no_slip" as const, friction: 0.1, radius: 3, shake: 2 };
    expect(setupRows(a, { ...INITIAL, law: "no_slip" })).toEqual([]);
    expect(setupRows(a, INITIAL).map(({ name }) => name)).toEqual(["Table", "Friction"]);
  });
});

describe("a link", () => {
  const ofMotion = (setup: Setup) => MOTION_FIELDS.map((name) => setup[name]);

  test("restores both set-ups, to the last digit", () => {
    const chance = new Chance(3);
    for (let k = 0; k < 200; k++) {
      const [setup, other] = [anySetup(chance), anySetup(chance)];
      const read = fromHash(`#${toHash(setup, undefined, other)}`);
      expect(read).toMatchObject({ setup, refusals: [] });
      expect(ofMotion(read.other!)).toEqual(ofMotion(other));
    }
  });

  test("names the body of the initial set-up, and nothing if nothing is compared", () => {
    expect(toHash(INITIAL, undefined, INITIAL)).toBe("with.body=can_2007");
    expect(fromHash("#with.body=can_2007").other).toEqual(INITIAL);
    expect(fromHash("#tilt=10").other).toBe(undefined);
  });

  test("a refused value of the second set-up is told apart", () => {
    const { setup, other, refusals } = fromHash("#with.tilt=abc");
    expect([setup, other]).toEqual([INITIAL, INITIAL]);
    expect(refusals).toMatchObject(
      [{ field: "with", message: /^Compared with: Tilt must be/ }].map(({ field, message }) => ({
        field,
        message: expect.stringMatching(message) as string,
      })),
    );
  });

  test("opens and ends a comparison in the lab, and leads back to itself", () => {
    const lab = labWith(core);
    readLink(lab, "#friction=0.1&with.body=coin&with.friction=0.4");
    expect(lab.otherSetup.value).toEqual({ ...INITIAL, body: "coin", friction: 0.4 });
    expect(hashOf(lab)).toBe("friction=0.1&with.body=coin&with.friction=0.4");
    readLink(lab, "#friction=0.1");
    expect(lab.otherSetup.value).toBe(undefined);
  });
});

describe("the clock of two motions", () => {
  const both = (a: Partial<Setup>, b: Partial<Setup>) => {
    const motions = [motionOf(core, { ...hand, ...a }), motionOf(core, { ...hand, ...b })] as const;
    return {
      motions,
      clock: new Clock(signal<Motion | undefined>(motions[0]), signal(motions[1])),
    };
  };

  test("is slow while either contact point races, and never lets one run faster than alone", () => {
    const { motions, clock } = both({}, { tilt: 10 });
    const step = 0.004;
    const fastest = motions.map(() => 0);
    let before = motions.map((motion) => motion.at([0]).moment(0).yaw);
    for (clock.play(); clock.playing.value;) {
      clock.advance(step);
      const yaws = motions.map((motion) => motion.at([clock.time.value]).moment(0).yaw);
      yaws.forEach((yaw, k) => {
        fastest[k] = Math.max(fastest[k]!, Math.abs(yaw - before[k]!) / step);
      });
      before = yaws;
    }
    for (const rate of fastest) {
      expect(rate).toBeLessThan(1.05 * MAX_CONTACT_RATE);
      expect(rate).toBeGreaterThan(0.8 * MAX_CONTACT_RATE);
    }
  });

  test("ends with the longer one", () => {
    expect(both({}, { duration: 2 }).clock.end).toBe(2);
    const { clock } = both({ duration: 2 }, {});
    expect(clock.end).toBe(2);
    clock.stretched.value = false;
    expect(clock.progressAt(1)).toBeCloseTo(0.5, 12);
    clock.progress = 0.75;
    expect(clock.time.value).toBeCloseTo(1.5, 12);
  });
});

test("a coin stands beside a can and is enlarged, bodies of about one size are ghosts", () => {
  const size = (body: Setup["body"]) => sizeOf({ ...INITIAL, body });
  const coin = layoutOf(size("can_2007"), size("coin"));
  expect(isBeside(coin)).toBe(true);
  expect(coin.times).toBeGreaterThan(5);
  for (const body of ["can_2007", "soda_can", "beer_bottle", "ring"] as const) {
    const layout = layoutOf(size("can_2007"), size(body));
    expect([isBeside(layout), layout.times], body).toEqual([false, 1]);
  }
});

describe("dashes along a path", () => {
  const line = { t: [0, 1, 2], x: [0, 3, 3], y: [0, 0, 4] };

  test("have one length, with gaps between them, round corners too", () => {
    const dashes = dashesAlong(line.t, line.x, line.y, 1, 100);
    expect(dashes.map(({ from, to }) => [...from, ...to])).toEqual([
      [0, 0, 1, 0],
      [2, 0, 3, 0],
      [3, 1, 3, 2],
      [3, 3, 3, 4],
    ]);
    expect([dashes[1]!.start, dashes[1]!.end]).toEqual([2 / 3, 1]);
  });

  test("are longer if there would be too many, and none without a path", () => {
    expect(dashesAlong(line.t, line.x, line.y, 1e-6, 2)).toHaveLength(2);
    expect(dashesAlong([0, 1], [2, 2], [3, 3], 1, 9)).toEqual([]);
  });

  test("are counted up to a time", () => {
    const dashes = dashesAlong(line.t, line.x, line.y, 1, 100);
    expect(dashesUntil(dashes, -1)).toBe(0);
    expect(dashesUntil(dashes, 1 / 6)).toBeCloseTo(0.5, 12);
    expect(dashesUntil(dashes, 0.5)).toBe(1);
    expect(dashesUntil(dashes, 9)).toBe(4);
  });
});

test("plots draw both motions at the times of both, and nothing after the end of the shorter one", () => {
  const [long, short] = [
    motionOf(core, { ...hand, duration: 0.5 }),
    motionOf(core, { tilt: 10, duration: 0.3 }),
  ];
  const [a, b] = [long.samples(1), short.samples(1)];
  const [one, two] = joined(a, b);
  const times = one.column("t");
  expect(times).toEqual(two.column("t"));
  expect(times.length).toBe(a.length + b.length);
  expect([...times]).toEqual([...times].sort((x, y) => x - y));
  times.forEach((time, k) => {
    const tilt = two.column("tilt")[k]!;
    if (time > short.end) expect(tilt).toBeNaN();
    else expect(Math.abs(tilt - short.at([time]).moment(0).tilt)).toBeLessThan(2e-3);
  });
  expect(one.column("tilt").some(Number.isNaN)).toBe(false);
});
