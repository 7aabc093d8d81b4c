// Times as the page writes them.

import { significant } from "./numbers";

export interface TimeUnit {
  name: string;
  size: number;
}

const UNITS: readonly TimeUnit[] = [
  { name: "s", size: 1 },
  { name: "ms", size: 1e-3 },
  { name: "µs", size: 1e-6 },
  { name: "ns", size: 1e-9 },
  { name: "ps", size: 1e-12 },
  { name: "fs", size: 1e-15 },
];

/** The largest unit that is not longer than a duration (s). */
export function unitFor(duration: number): TimeUnit {
  return UNITS.find((unit) => Math.abs(duration) >= unit.size * 0.9995) ?? UNITS[UNITS.length - 1]!;
}

/** A duration (s) in a suitable unit: 95.2 µs. */
export function formatDuration(seconds: number): string {
  if (seconds === 0) return "0 s";
  const unit = unitFor(seconds);
  // No line break separates the number from its unit.
  return `${significant(seconds / unit.size, 3)}\u00a0${unit.name}`;
}
