// Times as the page writes them.

import { significant } from "./numbers";

const UNITS = [
  { name: "s", size: 1 },
  { name: "ms", size: 1e-3 },
  { name: "µs", size: 1e-6 },
  { name: "ns", size: 1e-9 },
] as const;

export type TimeUnit = (typeof UNITS)[number];

/** The largest unit that is not longer than a duration (s). */
export function unitFor(duration: number): TimeUnit {
  return UNITS.find((unit) => Math.abs(duration) >= unit.size * 0.9995) ?? UNITS[3];
}

/** A duration (s) in a suitable unit: 95.2 µs. */
export function formatDuration(seconds: number): string {
  if (seconds === 0) return "0 s";
  const unit = unitFor(seconds);
  // No line break separates the number from its unit.
  return `${significant(seconds / unit.size, 3)}\u00a0${unit.name}`;
}
