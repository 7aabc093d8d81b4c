// Marks along a slider: buttons with the names of some of its values.

import { FIELDS } from "../setup/fields";
import type { NumberName } from "../inputs/number";
import { scaleOf } from "../inputs/scale";

/** A label centred nearer to the start of the slider (as a fraction of it) would begin outside it. */
const NEAR_THE_START = 0.08;

/** Puts a mark at the place of a value along its slider, or at the end if it lies beyond. */
export function placed(mark: HTMLElement, name: NumberName, value: number): HTMLElement {
  const { low, high } = scaleOf(FIELDS[name]);
  const part = Math.min((value - low) / (high - low), 1);
  mark.style.setProperty("--part", String(part));
  mark.classList.toggle("beyond", value > high);
  mark.classList.toggle("first", part < NEAR_THE_START);
  return mark;
}
