// Very short times and very small numbers are written for people.

import { expect, test } from "vitest";
import { formatDuration, significant } from "../../src/format";

test.each([
  [9.24e-15, "9.24\u00a0fs"],
  [4.5e-11, "45.0\u00a0ps"],
  [46.45e-6, "46.5\u00a0µs"],
  [9.24e-21, "9.24 × 10⁻⁶\u00a0fs"],
])("%s s", (seconds, text) => {
  expect(formatDuration(seconds)).toBe(text);
});

test("a tiny number is a power of ten", () => {
  expect(significant(-1.553e-11, 4)).toBe("−1.553 × 10⁻¹¹");
});
