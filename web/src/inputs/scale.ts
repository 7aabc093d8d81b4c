// Converts between a value and its position on a slider.

import type { NumberField } from "../setup/fields";

/** The positions of a slider and their values. */
export interface Scale {
  low: number;
  high: number;
  step: number;
  /** The value at a position. */
  value(position: number): number;
  position(value: number): number;
}

export function scaleOf(field: NumberField): Scale {
  const [low, high, step] = field.slider ?? [field.min, field.max, 0];
  if (field.finest !== undefined) return signedLog(field.finest, high);
  const identity = (x: number) => x;
  return { low, high, step, value: identity, position: identity };
}

const PER_DECADE = 20;

/** A logarithmic scale on both sides of 0, which is in the middle, with PER_DECADE steps per decade from
 * the finest to the largest value. */
function signedLog(finest: number, largest: number): Scale {
  const steps = Math.ceil(PER_DECADE * Math.log10(largest / finest));
  const size = (position: number) => finest * 10 ** ((Math.abs(position) - 1) / PER_DECADE);
  return {
    low: -steps - 1,
    high: steps + 1,
    step: 1,
    value: (position) =>
      position === 0
        ? 0
        : Math.sign(position) * Math.min(Number(size(position).toPrecision(2)), largest),
    position: (value) => {
      const distance = Math.abs(value) / finest;
      if (distance < 1) return 0;
      return Math.sign(value) * Math.min(1 + PER_DECADE * Math.log10(distance), steps + 1);
    },
  };
}
