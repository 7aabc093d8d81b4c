// How small and how fast the near-collision is for a body of this size, for whoever compares it with one
// at hand.

import { significant } from "../format/numbers";
import type { Passage } from "./passage";

const LENGTHS = [
  { name: "m", size: 1 },
  { name: "cm", size: 1e-2 },
  { name: "mm", size: 1e-3 },
  { name: "µm", size: 1e-6 },
  { name: "nm", size: 1e-9 },
] as const;
const SPEEDS = [
  { name: "km/s", size: 1e3 },
  { name: "m/s", size: 1 },
  { name: "cm/s", size: 1e-2 },
  { name: "mm/s", size: 1e-3 },
] as const;

/** How far from the table the far side of a rim (radius, m) is at the smallest tilt. */
export const gapOf = ({ minTilt }: Passage, radius: number): string =>
  written(2 * radius * Math.sin(minTilt), LENGTHS);

/** How fast the contact point then runs along that rim. */
export const speedOf = ({ yawRate }: Passage, radius: number): string =>
  written(radius * Math.abs(yawRate), SPEEDS);

function written(value: number, units: readonly { name: string; size: number }[]): string {
  const unit = units.find(({ size }) => value >= 0.9995 * size) ?? units[units.length - 1];
  return unit ? `${significant(value / unit.size, 2)}\u00a0${unit.name}` : "";
}
