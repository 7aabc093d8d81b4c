// The motion of the floor that a set-up describes: a pulse, with the same numbers as rimroll.ground in Python, or a record that a hand has made.

import { digits } from "../setup/export";
import type { Setup } from "../setup/setup";

type Vector = readonly [x: number, y: number, z: number];

/** An amplitude (m/s²) times a function of time with the largest value 1; times in s. */
export interface Pulse {
  shape: "constant" | "sine" | "cosine" | "ricker";
  amplitude: Vector;
  period: number;
  duration: number;
  center: number;
}

/** Samples of the acceleration, m/s², at equal intervals (s). */
export interface AccelerationRecord {
  step: number;
  samples: readonly Vector[];
}

export type Ground = Pulse | AccelerationRecord;

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

// A record of the floor's acceleration that a hand has made: from the path of the hand to samples, and from samples
// to a text for the address.

/** Time between two samples, s. */
export const STEP = 0.02;
/** Samples are multiples of 1/PER_UNIT m/s². */
const PER_UNIT = 100;
/** The numbers of a sample are below this many hundredths; a stronger record is scaled down. */
const LIMIT = 2048;
/** The largest number of samples; the field of the set-up has it, too. */
export const MAX_SAMPLES = 600;
/** The standard deviation of the Gaussian with which the path is smoothed, s. Fingers tremble faster. */
const SMOOTHING = 0.04;

const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/** A place of the hand, m, at a time, s. */
export interface HandAt {
  x: number;
  y: number;
  t: number;
}

/** The record of a path: the second differences of the smoothed path at equal times. The table begins and ends at
 * rest. */
export function recordOf(path: readonly HandAt[]): string {
  const first = path[0];
  const last = path[path.length - 1];
  if (!first || !last) return "";
  // The hand rests before and after, for as long as the smoothing reaches.
  const margin = Math.ceil((3 * SMOOTHING) / STEP) + 1;
  const count = Math.min(Math.ceil((last.t - first.t) / STEP) + 2 * margin + 1, MAX_SAMPLES);
  const times = Array.from({ length: count }, (_, k) => first.t + (k - margin) * STEP);
  const along = (key: "x" | "y") => acceleration(smoothed(times.map((t) => placeAt(path, t)[key])));
  const [x, y] = [along("x"), along("y")];
  const largest = Math.max(...x.map(Math.abs), ...y.map(Math.abs));
  const fit = Math.min(1, (LIMIT - 2) / PER_UNIT / largest);
  const [a, b] = [rounded(x.map((each) => each * fit)), rounded(y.map((each) => each * fit))];
  return a.map((each, k) => written(each) + written(b[k] as number)).join("");
}

/** The samples of a record, along x and y; a record without samples is a floor at rest. */
export function recordFrom(text: string): AccelerationRecord {
  const numbers = (text.match(/../g) ?? []).map(read);
  const samples = Array.from(
    { length: numbers.length / 2 },
    (_, k) => [numbers[2 * k] as number, numbers[2 * k + 1] as number, 0] as const,
  );
  while (samples.length < 2) samples.push([0, 0, 0]);
  return { step: STEP, samples };
}

/** Python code for the record. */
export function recordCode({ step, samples }: AccelerationRecord): string {
  const rows = samples.map((sample) => `(${sample.join(", ")})`);
  const lines = Array.from({ length: Math.ceil(rows.length / 4) }, (_, k) =>
    rows.slice(4 * k, 4 * k + 4).join(", "),
  );
  return `rr.ground.sampled(${step}, [\n    ${lines.join(",\n    ")},\n])`;
}

/** The place of the hand at a time, on straight lines between the known places. */
function placeAt(path: readonly HandAt[], t: number): Pick<HandAt, "x" | "y"> {
  const after = path.findIndex((place) => place.t >= t);
  const [from, to] = [path[after - 1], path[after]];
  if (!to) return path[path.length - 1] as HandAt;
  if (!from) return to;
  const part = (t - from.t) / (to.t - from.t);
  return { x: from.x + part * (to.x - from.x), y: from.y + part * (to.y - from.y) };
}

function smoothed(values: readonly number[]): number[] {
  const reach = Math.ceil((3 * SMOOTHING) / STEP);
  const weights = Array.from({ length: 2 * reach + 1 }, (_, k) =>
    Math.exp(-0.5 * (((k - reach) * STEP) / SMOOTHING) ** 2),
  );
  const total = weights.reduce((sum, weight) => sum + weight);
  const last = values.length - 1;
  return values.map((_, place) => {
    const near = weights.map(
      (weight, k) => weight * (values[Math.min(Math.max(place + k - reach, 0), last)] as number),
    );
    return near.reduce((sum, value) => sum + value) / total;
  });
}

/** The second differences; zero at both ends. */
function acceleration(path: readonly number[]): number[] {
  return path.map((here, k) => {
    const [before, after] = [path[k - 1], path[k + 1]];
    if (before === undefined || after === undefined) return 0;
    return (before - 2 * here + after) / STEP ** 2;
  });
}

/** Whole hundredths, whose sum is off by less than one, so that the table does not drift. */
function rounded(values: readonly number[]): number[] {
  let rest = 0;
  return values.map((value) => {
    const wanted = PER_UNIT * value + rest;
    const whole = Math.round(wanted) || 0;
    rest = wanted - whole;
    return whole;
  });
}

/** A whole number as two digits to the base of 64. */
function written(hundredths: number): string {
  const positive = hundredths + LIMIT;
  return `${DIGITS[positive >> 6]}${DIGITS[positive & 63]}`;
}

function read(pair: string): number {
  const [high, low] = [DIGITS.indexOf(pair[0] as string), DIGITS.indexOf(pair[1] as string)];
  return (64 * high + low - LIMIT) / PER_UNIT;
}
