// What an ideal gyroscope in the body shows: the angular velocity along axes fixed in the body.

import type { Moment, Moments, Motion } from "../core/motion";

/** rad/s along the body's axes; z is the symmetry axis. */
export interface Rates {
  x: Float64Array;
  y: Float64Array;
  z: Float64Array;
}

type Turning = Pick<Moment, "tilt" | "tilt_rate" | "yaw_rate" | "spin" | "axial_spin">;

/** The rates at a moment, as `motion.body_angular_velocity` of Python: ω_x + i ω_y is
 * (dψ/dt sin φ − i dφ/dt) exp(−iθ). They stay bounded where the rates of yaw and spin do not. */
export function bodyRatesAt({ tilt, tilt_rate, yaw_rate, spin, axial_spin }: Turning) {
  const along = yaw_rate * Math.sin(tilt);
  const [c, s] = [Math.cos(spin), Math.sin(spin)];
  return { x: along * c - tilt_rate * s, y: -along * s - tilt_rate * c, z: axial_spin };
}

/** The rates at many moments, which the three lines of a plot share. */
export function bodyRates(moments: Moments): Rates {
  const known = computed.get(moments);
  if (known) return known;
  const rates = ratesOf(moments);
  computed.set(moments, rates);
  return rates;
}

const computed = new WeakMap<Moments, Rates>();

function ratesOf(moments: Moments): Rates {
  const [x, y] = [new Float64Array(moments.length), new Float64Array(moments.length)];
  const ratesAt = bodyRatesIn(moments);
  for (let k = 0; k < moments.length; k++) {
    const rates = ratesAt(k);
    x[k] = rates.x;
    y[k] = rates.y;
  }
  return { x, y, z: moments.column("axial_spin").slice() };
}

/** Gives the rates at each of many moments by its index. */
export function bodyRatesIn(moments: Moments): (index: number) => ReturnType<typeof bodyRatesAt> {
  const [tilt, spin, axial] = (["tilt", "spin", "axial_spin"] as const).map((name) =>
    moments.column(name),
  ) as [Float64Array, Float64Array, Float64Array];
  const [tiltRate, yawRate] = [moments.column("tilt_rate"), moments.column("yaw_rate")];
  return (k) =>
    bodyRatesAt({
      tilt: tilt[k]!,
      tilt_rate: tiltRate[k]!,
      yaw_rate: yawRate[k]!,
      spin: spin[k]!,
      axial_spin: axial[k]!,
    });
}

// The record of an ideal gyroscope in the body, as the app phyphox saves it: `rimroll gyro` reads it. The hand is that
// of rimroll's simulated sensors: the body stands, is tipped smoothly, is held, and is let go.

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
