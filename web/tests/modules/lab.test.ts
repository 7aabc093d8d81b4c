// The state of the page.

import { effect } from "@preact/signals-core";
import { beforeAll, describe, expect, test, vi } from "vitest";
import { type Core, Refused } from "../../src/core/core";
import { Motion } from "../../src/core/motion";
import { Hands } from "../../src/scene/hands";
import { ending } from "../../src/verdict/words";
import { loadCore } from "../given/core";
import { labWith } from "../given/page";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

test("a change of the set-up notifies effects once", () => {
  const lab = labWith(core);
  lab.clock.time.value = 1;
  lab.clock.playing.value = true;
  const seen: unknown[] = [];
  effect(() => {
    seen.push([lab.setup.value.tilt, lab.clock.time.value, lab.clock.playing.value]);
  });
  lab.change({ tilt: 10 });
  expect(seen).toEqual([
    [20, 1, true],
    [10, 0, false],
  ]);
});

test("a body that is released as before is shown from the release again", () => {
  const lab = labWith(core, { sideways: 0.003 });
  const hands = new Hands(lab);
  lab.clock.time.value = 0;
  hands.take();
  lab.clock.time.value = 1;
  hands.release(false);
  expect([lab.clock.time.value, lab.clock.playing.value]).toEqual([0, true]);
});

test("a change just after the page has opened can be undone", () => {
  const lab = labWith(core, { sideways: 0.02 });
  lab.beginHere();
  expect(lab.canUndo.value).toBe(false);
  lab.change({ body: "coin" });
  lab.undo();
  expect([lab.setup.value.body, lab.setup.value.sideways]).toEqual(["can_2007", 0.02]);
});

describe("a motion of many steps", () => {
  const LONG = { body: "coin" } as const;

  test("is first computed in part, with the same bits", () => {
    const lab = labWith(core, LONG);
    const begun = lab.motion.value!;
    expect(begun.end).toBeLessThan(3);
    expect(ending(lab.outcome.value, lab.setup.value)).toMatch(/still being computed/);
    expect(begun.turns.length).toBeGreaterThan(0);
    const times = [0.1, 0.5, 0.9, 0.999].map((part) => part * begun.end);
    const before = times.map((time) => begun.at([time]).moment(0));
    lab.complete();
    const whole = lab.motion.value!;
    expect([whole.status, whole.end]).toEqual(["finished", 3]);
    expect(times.map((time) => whole.at([time]).moment(0))).toEqual(before);
  });

  test("is completed after a while without a change, at the time shown", async () => {
    const lab = labWith(core, LONG);
    lab.clock.time.value = 0.2;
    await vi.waitFor(() => expect(lab.motion.value!.end).toBe(3), 10_000);
    expect(lab.clock.time.value).toBe(0.2);
  });

  test("is computed in part again after a change", () => {
    const lab = labWith(core, LONG);
    lab.complete();
    lab.change({ tilt: 21 });
    expect(lab.motion.value!.end).toBeLessThan(3);
  });
});

test("a motion of few steps is computed at once, and once", () => {
  const lab = labWith(core);
  const motion = lab.motion.value;
  expect(motion?.end).toBe(3);
  lab.complete();
  expect(lab.motion.value).toBe(motion);
});

describe("where the core gives no answer", () => {
  test("a motion without a theory is freed", () => {
    const forget = vi.spyOn(Motion.prototype, "forget");
    const theory = vi.spyOn(core, "theory").mockImplementation(() => {
      throw new Refused("there is no theory of it");
    });
    const lab = labWith(core, { tilt: 21 });
    expect(lab.outcome.value).toEqual({ refused: "there is no theory of it" });
    expect(forget).toHaveBeenCalled();
    theory.mockRestore();
    forget.mockRestore();
  });

  test("a failed computation is an outcome in words, and the next one works", () => {
    const simulate = vi.spyOn(core, "simulation").mockImplementation(() => {
      throw new WebAssembly.RuntimeError("unreachable");
    });
    const lab = labWith(core, { tilt: 22 });
    expect(ending(lab.outcome.value, lab.setup.value)).toMatch(
      /^There is no motion.*computation failed/,
    );
    simulate.mockRestore();
    lab.change({ tilt: 23 });
    expect(lab.motion.value?.status).toBe("finished");
  });

  test("an error of the page itself is not hidden", () => {
    const simulate = vi.spyOn(core, "simulation").mockImplementation(() => {
      throw new TypeError("no such thing");
    });
    expect(() => labWith(core, { tilt: 24 })).toThrow("no such thing");
    simulate.mockRestore();
  });
});
