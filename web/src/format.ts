// Numbers, sizes and times as the page writes them.

import { NUMBERS } from "./words/language";

/** A number with at most `digits` significant digits, without trailing zeros. */
export function formatNumber(value: number, digits = 6): string {
  if (Number.isNaN(value)) return "–";
  return written(String(Number(value.toPrecision(digits))));
}

/** A number with all its digits: reading the text gives the same number. */
export const formatExact = (value: number): string => written(String(value));

/** A number with a number of decimals. */
export const formatFixed = (value: number, decimals: number): string =>
  written(value.toFixed(decimals));

/** A number with `digits` significant digits, trailing zeros included. */
export const formatPrecise = (value: number, digits: number): string =>
  written(value.toPrecision(digits));

/** A number with `digits` significant digits, trailing zeros included; in powers of ten only below 1e-5. */
export function significant(exact: number, digits: number): string {
  if (exact === 0) return "0";
  const value = Number(exact.toPrecision(digits));
  const size = Math.floor(Math.log10(Math.abs(value)));
  if (size < -5) return formatWide(value, digits);
  return written(grouped(value.toFixed(Math.min(Math.max(digits - 1 - size, 0), 12))));
}

/** A number as `formatNumber` writes it, or as a power of ten if it is very large or very small. */
export function formatWide(value: number, digits: number): string {
  const size = Math.abs(value);
  if (!Number.isFinite(value) || value === 0 || (size >= 1e-5 && size < 1e6)) {
    const text = formatNumber(value, digits);
    if (text.includes("e")) return written(value.toFixed(6));
    return size >= 1e4 ? text.replace(/(\d)(?=(\d{3})+$)/g, "$1\u202f") : text;
  }
  const [mantissa = "", exponent = ""] = value.toExponential(digits - 1).split("e");
  const raised = [...exponent.replace("+", "")]
    .map((digit) => (digit === "-" ? "⁻" : SUPERSCRIPTS[Number(digit)]))
    .join("");
  return `${written(mantissa)} × 10${raised}`;
}

export const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** An angle in rad, written in degrees with a number of decimals; zero has no sign. */
export function formatDegrees(angle: number, decimals: number): string {
  if (Number.isNaN(angle)) return "–";
  const text = ((angle * 180) / Math.PI).toFixed(decimals);
  return `${written(Number(text) === 0 ? text.replace("-", "") : text)}°`;
}

/** A number with its unit, separated by a space unless the unit is a sign. */
export function withUnit(value: string, unit: string): string {
  if (unit === "%") return value + NUMBERS.percentGap + unit;
  return unit === "" || unit === "°" ? value + unit : `${value} ${unit}`;
}

/** Writes the digits of a number as the visitor reads them: minus signs are as wide as a plus. */
export const written = (digits: string, { decimal } = NUMBERS): string =>
  digits.replaceAll("-", "−").replace(".", decimal);

/** Separates thousands by narrow no-break spaces, from 10 000 on. */
function grouped(text: string): string {
  const [whole = "", ...part] = text.split(".");
  const spaced =
    whole.replace("-", "").length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, "\u202f") : whole;
  return [spaced, ...part].join(".");
}

// Lengths and speeds of any size, to compare them with everyday ones.

interface Unit {
  name: string;
  size: number;
}

const LENGTHS: readonly Unit[] = [
  { name: "m", size: 1 },
  { name: "cm", size: 1e-2 },
  { name: "mm", size: 1e-3 },
  { name: "µm", size: 1e-6 },
  { name: "nm", size: 1e-9 },
];
const SPEEDS: readonly Unit[] = [
  { name: "km/s", size: 1e3 },
  { name: "m/s", size: 1 },
  { name: "cm/s", size: 1e-2 },
  { name: "mm/s", size: 1e-3 },
];

/** A length (m) with two digits: 3.5 µm. */
export const formatLengthShort = (length: number): string => inUnit(length, LENGTHS);

/** A speed (m/s) with two digits: 7.6 km/s. */
export const formatSpeed = (speed: number): string => inUnit(speed, SPEEDS);

function inUnit(value: number, units: readonly Unit[]): string {
  const unit = units.find(({ size }) => value >= 0.9995 * size) ?? units[units.length - 1];
  return unit ? `${significant(value / unit.size, 2)}\u00a0${unit.name}` : "";
}

// Times as the page writes them.

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
