// The pulse of a set-up, with the same numbers as rimroll.ground in Python.

import { digits } from "../setup/digits";
import type { Setup } from "../setup/setup";
import type { Pulse } from "./shaken_core";

/** Periods from the centre of a Ricker wavelet to its beginning and end, as in Python. */
const CALM = 2;

/** The horizontal amplitude along x and y, and the vertical one, m/s². */
function amplitudeOf({ shake, direction, vertical }: Readonly<Setup>): Pulse["amplitude"] {
  const angle = (direction * Math.PI) / 180;
  return [shake * Math.cos(angle), shake * Math.sin(angle), vertical];
}

export function pulseOf(setup: Readonly<Setup>): Pulse {
  const { pulse, period, cycles } = setup;
  const common = { amplitude: amplitudeOf(setup), period, center: 0 };
  switch (pulse) {
    case "sine":
    case "cosine":
      return { ...common, shape: pulse, duration: cycles * period };
    case "half_sine":
      return { ...common, shape: "sine", period: 2 * period, duration: period };
    case "ricker":
      return {
        ...common,
        shape: pulse,
        center: CALM * period,
        duration: CALM * period + CALM * period,
      };
    case "rectangular":
      return { ...common, shape: "constant", duration: period };
  }
}

/** Python code for the pulse. */
export function pulseCode(setup: Readonly<Setup>): string {
  const { pulse, period, cycles } = setup;
  const times: Record<Setup["pulse"], string> = {
    sine: `period=${period}, cycles=${cycles}`,
    cosine: `period=${period}, cycles=${cycles}`,
    half_sine: `duration=${period}`,
    ricker: `period=${period}`,
    rectangular: `duration=${period}`,
  };
  const amplitude = amplitudeOf(setup).map(digits).join(", ");
  return `rr.ground.${pulse}(amplitude=(${amplitude}), ${times[pulse]})`;
}
