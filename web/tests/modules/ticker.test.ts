// The ticker advances the clock frame by frame.

import { signal } from "@preact/signals-core";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Clock } from "../../src/clock";
import { startTicker } from "../../src/timing";

let pictures: ((now: number) => void)[] = [];
beforeEach(() => {
  pictures = [];
  vi.stubGlobal("requestAnimationFrame", (draw: (now: number) => void) => pictures.push(draw));
  vi.spyOn(performance, "now").mockReturnValue(0);
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

function clockThat(advance: (seconds: number) => void): Clock {
  const playing = signal(false);
  const pause = () => (playing.value = false);
  return { playing, advance, pause } as unknown as Clock;
}

const show = (now: number) => pictures.splice(0).forEach((draw) => draw(now));

test("a frame advances the time since the previous one, at most a tenth of a second", () => {
  const passed: number[] = [];
  const clock = clockThat((seconds) => passed.push(seconds));
  startTicker(clock);
  show(5);
  clock.playing.value = true;
  for (const now of [10, 30, 1000]) show(now);
  expect(passed).toEqual([0.01, 0.02, 0.1]);
  clock.pause();
  show(1010);
  expect(pictures).toEqual([]);
});

test("after a failure it plays again when it is asked to", () => {
  const advance = vi.fn(() => {
    throw new Error("once");
  });
  const clock = clockThat(advance);
  startTicker(clock);
  clock.playing.value = true;
  expect(() => show(16)).toThrow("once");
  expect(clock.playing.value).toBe(false);
  advance.mockImplementation((() => {}) as () => never);
  clock.playing.value = true;
  show(32);
  show(48);
  expect(advance).toHaveBeenCalledTimes(3);
});
