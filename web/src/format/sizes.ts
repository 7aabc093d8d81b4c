// Lengths and speeds of any size, to compare them with everyday ones.

import { significant } from "./numbers";

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
export const formatLengthShort = (length: number): string => written(length, LENGTHS);

/** A speed (m/s) with two digits: 7.6 km/s. */
export const formatSpeed = (speed: number): string => written(speed, SPEEDS);

function written(value: number, units: readonly Unit[]): string {
  const unit = units.find(({ size }) => value >= 0.9995 * size) ?? units[units.length - 1];
  return unit ? `${significant(value / unit.size, 2)}\u00a0${unit.name}` : "";
}
