// The controls of the floor: whether and how it moves, and what stands on it.

import { effect } from "@preact/signals-core";
import { button, element } from "../elements";
import { choiceButtons, choiceList } from "../inputs/choice";
import { type NumberName, numberRow } from "../inputs/number";
import type { SetupForm } from "../inputs/setup_form";
import { padFor } from "./pad";
import { words } from "../words/words";

const PULSE: NumberName[] = ["shake", "period", "cycles", "direction", "vertical"];

/** The duration of a push, s. */
const PUSH = 0.2;

export function mountFloorControls(form: SetupForm, place: HTMLElement): void {
  const moving = element(
    "div",
    {},
    choiceButtons(form, "start"),
    pulseControls(form),
    padFor(form),
    choiceList(form, "flat"),
  );
  place.append(
    choiceButtons(form, "floor"),
    moving,
    element(
      "div",
      { class: "buttons" },
      button(words.floor.push, () => push(form), {
        "data-help": words.floor.pushHelp,
      }),
      button(words.floor.shake, () => form.letGo(), {
        id: "shake",
        "data-help": words.floor.shakeHelp,
      }),
    ),
    element("p", { class: "help always" }, words.floor.note),
  );
  const shake = place.querySelector<HTMLButtonElement>("#shake") as HTMLButtonElement;
  effect(() => {
    const { floor } = form.lab.setup.value;
    moving.hidden = floor === "rest";
    shake.disabled = floor === "rest";
  });
}

function pulseControls(form: SetupForm): HTMLElement {
  const isOnce = () => {
    const { pulse } = form.lab.setup.value;
    return pulse === "sine" || pulse === "cosine" ? undefined : words.floor.onceOnly;
  };
  const rows = PULSE.map((name) => numberRow(form, name, name === "cycles" ? isOnce : undefined));
  const group = element("div", {}, choiceList(form, "pulse"), ...rows.map(({ row }) => row));
  effect(() => {
    group.hidden = form.lab.setup.value.floor !== "pulse";
  });
  return group;
}

/** A short push away from the eye of the visitor, for those who cannot drag. */
function push(form: SetupForm): void {
  const degrees = Math.round((form.lab.azimuth * 180) / Math.PI) + 180;
  form.set("floor", "pulse");
  form.set("pulse", "half_sine");
  form.set("period", PUSH);
  form.set("direction", degrees - 360 * Math.floor((degrees + 180) / 360));
  form.letGo();
}
