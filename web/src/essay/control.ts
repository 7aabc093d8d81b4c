// Controls of the scenes: sliders, and buttons one of which is pressed.

import { button, element } from "../elements";
import type { Setup } from "../setup/setup";
import type { Choice, Quantity } from "./scenes";

/** A slider with its name and what it says of its place. */
export interface Field {
  root: HTMLElement;
  input: HTMLInputElement;
  write(text: string): void;
}

export function field(
  id: string,
  label: string,
  bounds: Record<"min" | "max" | "step" | "value", number>,
): Field {
  const input = element("input", { type: "range", id: `${id}-control`, ...bounds });
  const output = element("output", { for: input.id });
  const named = element("label", { for: input.id }, label);
  return {
    root: element("div", { class: "control" }, named, output, input),
    input,
    write(text) {
      output.textContent = text;
      input.setAttribute("aria-valuetext", text);
    },
  };
}

export interface Slider {
  root: HTMLElement;
  /** The part of the set-up that is chosen. */
  setup(): Partial<Setup>;
  /** Place along the slider, 0 to 1. */
  part(): number;
}

/** Steps of a logarithmic slider. */
const STEPS = 100;

/** A slider for a quantity; `changed` is called after each change. */
export function slider(quantity: Quantity, id: string, changed: () => void): Slider {
  const { label, low, high, step, initial, logarithmic = false, marks } = quantity;
  const bounds = logarithmic
    ? { min: 0, max: STEPS, step: 1, value: Math.round(STEPS * partOf(quantity, initial)) }
    : { min: low, max: high, step, value: initial };
  const { root, input, write } = field(id, label, bounds);
  const value = () =>
    logarithmic ? low * (high / low) ** (Number(input.value) / STEPS) : Number(input.value);
  const moved = () => {
    write(quantity.words(value()));
    changed();
  };
  input.addEventListener("input", moved);
  write(quantity.words(value()));
  if (marks) {
    const named = Object.entries(marks).map(([name, at]) => {
      const mark = button(name, () => {
        input.value = String(at);
        moved();
      });
      mark.style.setProperty("--part", String(partOf(quantity, at)));
      return mark;
    });
    root.append(element("div", { class: "named" }, ...named));
  }
  return {
    root,
    setup: () => quantity.setup(value()),
    part: () => partOf(quantity, value()),
  };
}

/** Buttons, one of which is pressed. */
export function choice(
  { label, options }: Choice,
  changed: () => void,
): { root: HTMLElement; setup(): Partial<Setup> } {
  let chosen = options[0];
  const buttons = options.map((option) =>
    button(option.name, () => {
      chosen = option;
      press();
      changed();
    }),
  );
  const press = () =>
    buttons.forEach((one, k) => one.setAttribute("aria-pressed", String(options[k] === chosen)));
  press();
  const named = { class: "control choice", role: "group", "aria-label": label };
  return { root: element("div", named, ...buttons), setup: () => chosen?.setup ?? {} };
}

/** Values of a slider from one end to the other. */
export const valuesOf = ({ low, high, logarithmic }: Quantity, count: number): number[] =>
  Array.from({ length: count }, (_, k) => {
    const part = k / (count - 1);
    return logarithmic ? low * (high / low) ** part : low + part * (high - low);
  });

const partOf = ({ low, high, logarithmic }: Quantity, value: number) =>
  logarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
