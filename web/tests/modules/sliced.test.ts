// A long sequence is computed in short tasks, and a change begins it anew.

import { signal } from "@preact/signals-core";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { sliced } from "../../src/timing";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** Counts from `first`; each number takes `cost` ms. */
function* counting(first: number, count: number, cost: number): Generator<number, void> {
  for (let k = 0; k < count; k++) {
    now += cost;
    yield first + k;
  }
}

let now = 0;

beforeEach(() => {
  now = 0;
  vi.spyOn(performance, "now").mockImplementation(() => now);
});

test("no task takes longer than a slice and one item", () => {
  const { results, complete } = sliced(() => counting(0, 100, 5));
  const tasks = [now];
  expect(complete.value).toBe(false);
  expect(results.value.length).toBe(4);
  while (!complete.value) {
    const before = now;
    vi.advanceTimersToNextTimer();
    tasks.push(now - before);
  }
  expect(results.value).toEqual(Array.from({ length: 100 }, (_, k) => k));
  expect(Math.max(...tasks)).toBeLessThanOrEqual(25);
  expect(vi.getTimerCount()).toBe(0);
});

test("what takes no time is there at once", () => {
  const { results, complete } = sliced(() => counting(0, 10, 0));
  expect([results.value.length, complete.value]).toEqual([10, true]);
});

test("a change begins anew, and nothing of the old sequence appears", () => {
  const first = signal(0);
  const { results, complete } = sliced(() => counting(first.value, 50, 5));
  vi.advanceTimersToNextTimer();
  first.value = 1000;
  vi.runAllTimers();
  expect(complete.value).toBe(true);
  expect(results.value.length).toBe(50);
  expect(Math.min(...results.value)).toBe(1000);
});
