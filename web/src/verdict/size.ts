// The gap and the speed of the near-collision for a body of this size, to compare them with everyday
// lengths and speeds.

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

/** Height of the highest point of a rim (radius in m) above the table at the smallest tilt. */
export const gapOf = ({ minTilt }: Passage, radius: number): string =>
  written(2 * radius * Math.sin(minTilt), LENGTHS);

/** Speed of the contact point along a rim (radius in m) at the smallest tilt. */
export const speedOf = ({ yawRate }: Passage, radius: number): string =>
  written(radius * Math.abs(yawRate), SPEEDS);

function written(value: number, units: readonly { name: string; size: number }[]): string {
  const unit = units.find(({ size }) => value >= 0.9995 * size) ?? units[units.length - 1];
  return unit ? `${significant(value / unit.size, 2)}\u00a0${unit.name}` : "";
}
