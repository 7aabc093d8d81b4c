// The one control of a scene.

import { button, element } from "../elements";
import type { Setup } from "../setup/setup";
import type { Choice, Quantity } from "./scenes";

export interface Control {
  root: HTMLElement;
  /** The part of the set-up that is chosen. */
  setup(): Partial<Setup>;
  /** Place along the slider, 0 to 1. */
  part(): number;
}

/** Steps of a logarithmic slider. */
const STEPS = 100;

/** A slider; `changed` is called after each change. */
export function slider(quantity: Quantity, id: string, changed: () => void): Control {
  const { label, low, high, step, initial, logarithmic = false, marks } = quantity;
  const bounds = logarithmic
    ? { min: 0, max: STEPS, step: 1, value: Math.round(STEPS * partOf(quantity, initial)) }
    : { min: low, max: high, step, value: initial };
  const input = element("input", { type: "range", id: `${id}-control`, ...bounds });
  const output = element("output", { for: input.id });
  const value = () =>
    logarithmic ? low * (high / low) ** (Number(input.value) / STEPS) : Number(input.value);
  const write = () => {
    output.textContent = quantity.words(value());
    input.setAttribute("aria-valuetext", output.textContent);
  };
  input.addEventListener("input", () => {
    write();
    changed();
  });
  write();
  const root = element(
    "div",
    { class: "control" },
    element("label", { for: input.id }, label),
    output,
    input,
  );
  if (marks) {
    const named = Object.entries(marks).map(([name, at]) => {
      const mark = button(name, () => {
        input.value = String(at);
        write();
        changed();
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
export function choice({ label, options }: Choice, changed: () => void): Control {
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
  return {
    root: element(
      "div",
      { class: "control choice", role: "group", "aria-label": label },
      ...buttons,
    ),
    setup: () => chosen?.setup ?? {},
    part: () => 0,
  };
}

/** Values of a slider from one end to the other. */
export const valuesOf = ({ low, high, logarithmic }: Quantity, count: number): number[] =>
  Array.from({ length: count }, (_, k) => {
    const part = k / (count - 1);
    return logarithmic ? low * (high / low) ** part : low + part * (high - low);
  });

const partOf = ({ low, high, logarithmic }: Quantity, value: number) =>
  logarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
