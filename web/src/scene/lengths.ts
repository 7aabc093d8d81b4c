// Lengths as the picture writes them.

import { formatNumber, significant } from "../format/numbers";
import { formatLengthShort } from "../format/sizes";

/** The largest of 1, 2 and 5 times a power of ten that does not exceed a length, m. */
export function roundLength(max: number): number {
  const ten = 10 ** Math.floor(Math.log10(max) + 1e-9);
  const times = max / ten;
  return ten * (times >= 5 ? 5 : times >= 2 ? 2 : 1);
}

/** The largest power of ten that does not exceed a length, m. */
export const powerOfTen = (max: number) => 10 ** Math.floor(Math.log10(max) + 1e-9);

/** The unit that suits a length, m. */
export function unitOf(length: number): { name: string; size: number } {
  if (length < 0.0099) return { name: "mm", size: 0.001 };
  if (length < 0.99) return { name: "cm", size: 0.01 };
  return { name: "m", size: 1 };
}

/** A length (m) of any size, with two or three digits. */
export function formatSmall(length: number): string {
  if (length === 0) return "0\u00a0cm";
  // Tens of centimetres have a decimal, like millimetres.
  return length >= 0.1 && length < 1
    ? `${significant(100 * length, 3)}\u00a0cm`
    : formatLengthShort(length);
}

export function formatLength(length: number): string {
  const { name, size } = unitOf(length);
  return `${formatNumber(length / size)} ${name}`;
}
