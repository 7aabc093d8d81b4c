// Lengths as the picture writes them.

import { significant } from "../format/numbers";

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

const SMALL = [
  { name: "m", size: 1 },
  { name: "cm", size: 1e-2 },
  { name: "mm", size: 1e-3 },
  { name: "µm", size: 1e-6 },
  { name: "nm", size: 1e-9 },
] as const;

/** A length (m) of any size, with two or three digits. */
export function formatSmall(length: number): string {
  if (length === 0) return "0\u00a0cm";
  const unit = SMALL.find(({ size }) => length >= 0.9995 * size) ?? SMALL[4];
  return `${significant(length / unit.size, length >= 0.1 ? 3 : 2)}\u00a0${unit.name}`;
}

export function formatLength(length: number): string {
  const { name, size } = unitOf(length);
  return `${Number((length / size).toPrecision(6))} ${name}`;
}
