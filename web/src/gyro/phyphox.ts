// The record of an ideal gyroscope in the body, as the app phyphox saves it: `rimroll gyro` reads it. The hand is that
// of rimroll's simulated sensors: the body stands, is tipped smoothly, is held, and is let go.

import type { Motion } from "../core/motion";
import { bodyRates } from "./rates";

/** Samples per second. */
export const SAMPLING_RATE = 200;
/** Times for which the body stands, is tipped and is held, s. */
const [STANDING, TIPPING, HELD] = [1, 0.6, 0.5];
/** Time of the release in the record, s. */
export const RELEASE = STANDING + TIPPING + HELD;

const TITLES = [
  "Time (s)",
  "Gyroscope x (rad/s)",
  "Gyroscope y (rad/s)",
  "Gyroscope z (rad/s)",
  "Absolute (rad/s)",
];

/** The first line of a record that is not measured, as in files of rimroll. */
const SIMULATED = "# simulated by rimroll, not measured";

export function toPhyphox(motion: Motion): string {
  const count = Math.floor((RELEASE + motion.end) * SAMPLING_RATE);
  const times = Array.from({ length: count }, (_, k) => k / SAMPLING_RATE);
  const since = times.map((time) => time - RELEASE);
  const rates = bodyRates(motion.at(since));
  const start = motion.at([0]).moment(0);
  const rows = times.map((time, k) => {
    const [x, y, z] = since[k]! < 0 ? inHand(time, start) : [rates.x[k]!, rates.y[k]!, rates.z[k]!];
    const values = [x, y, z, Math.hypot(x, y, z)].map((rate) =>
      String(Number(rate.toPrecision(6))),
    );
    return [time.toFixed(6), ...values].join(",");
  });
  return [SIMULATED, TITLES.map((title) => `"${title}"`).join(","), ...rows, ""].join("\n");
}

/** The rates while a hand has the body. The tilt rises like x − sin(2πx)/2π. */
function inHand(
  time: number,
  { tilt, spin }: { tilt: number; spin: number },
): [number, number, number] {
  const part = (time - STANDING) / TIPPING;
  if (part <= 0 || part >= 1) return [0, 0, 0];
  const speed = (tilt / TIPPING) * (1 - Math.cos(2 * Math.PI * part));
  return [-speed * Math.sin(spin), -speed * Math.cos(spin), 0];
}
