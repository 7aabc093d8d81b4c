// What an ideal gyroscope in the body shows: the angular velocity along axes fixed in the body.

import type { Moment, Moments } from "../core/motion";

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
