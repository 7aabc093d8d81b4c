// Times and numbers as they are written for the visitor.

const UNITS = [
  { name: "s", size: 1 },
  { name: "ms", size: 1e-3 },
  { name: "µs", size: 1e-6 },
  { name: "ns", size: 1e-9 },
] as const;

export type TimeUnit = (typeof UNITS)[number];

/** The largest unit of which a duration (s) has at least one. */
export function unitFor(duration: number): TimeUnit {
  return UNITS.find((unit) => Math.abs(duration) >= unit.size * 0.9995) ?? UNITS[3];
}

/** A duration (s) in the unit that suits it: 95.2 µs. */
export function duration(seconds: number): string {
  if (seconds === 0) return "0 s";
  const unit = unitFor(seconds);
  // The two are not parted at the end of a line.
  return `${significant(seconds / unit.size, 3)}\u00a0${unit.name}`;
}

/** A number with so many digits that count, without powers of ten unless it is tiny, and with a real
 * minus. */
export function significant(exact: number, digits: number): string {
  if (exact === 0) return "0";
  const value = Number(exact.toPrecision(digits));
  const size = Math.floor(Math.log10(Math.abs(value)));
  if (size < -5) return signed(value.toExponential(digits - 1));
  return signed(grouped(value.toFixed(Math.min(Math.max(digits - 1 - size, 0), 12))));
}

/** With the minus that is as wide as a plus. */
export const signed = (text: string) => text.replaceAll("-", "−");

/** Thousands apart by narrow spaces that do not break, from 10 000 on. */
function grouped(text: string): string {
  const [whole = "", ...part] = text.split(".");
  const spaced =
    whole.replace("-", "").length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, "\u202f") : whole;
  return [spaced, ...part].join(".");
}
