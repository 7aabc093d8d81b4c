// The controls of the floor: whether and how it moves, what stands on it, and a pad on which a hand moves it.

import { effect } from "@preact/signals-core";
import { button, element } from "../elements";
import { choiceButtons, choiceList, type NumberName, numberRow } from "../controls/inputs";
import type { SetupForm } from "../controls/setup_form";
import { words } from "../words/words";
import { type HandAt, MAX_SAMPLES, recordOf, STEP } from "./ground";

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

// A pad on which a hand moves the table. Its path becomes the record of the floor when the hand lets go.

/** Metres of the table for a pixel of the pad. */
const SCALE = 1e-3;
/** The longest path, s; smoothing makes the record a little longer. */
const LONGEST = MAX_SAMPLES * STEP - 1;
/** How far the table moves with a key, px, and how long that takes, s. */
const [KEY_STEP, KEY_TIME] = [40, 0.12];
/** After this time without a key the path ends, s. */
const KEY_PAUSE = 0.8;
/** The motion goes on after the end of the record for this time, s. */
const AFTER = 1;

const KEYS: Record<string, readonly [right: number, up: number]> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

export function padFor(form: SetupForm): HTMLElement {
  const dot = element("i");
  const pad = element(
    "div",
    {
      class: "pad",
      tabindex: 0,
      role: "application",
      "aria-label": words.floor.pad,
      "aria-describedby": "pad-help",
    },
    dot,
  );
  const help = element("p", { id: "pad-help", class: "help always" }, words.floor.padHelp);
  const hand = new Hand(form, pad, dot);
  pad.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    pad.setPointerCapture(event.pointerId);
    hand.begin();
    hand.from(event.clientX, event.clientY);
  });
  pad.addEventListener("pointermove", (event) => hand.to(event.clientX, event.clientY));
  for (const kind of ["pointerup", "pointercancel"]) pad.addEventListener(kind, () => hand.end());
  pad.addEventListener("keydown", (event) => {
    const way = KEYS[event.key];
    if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    if (!event.repeat) hand.key(...way);
  });
  const group = element("div", {}, pad, help);
  effect(() => {
    group.hidden = form.lab.setup.value.floor !== "hand";
  });
  return group;
}

/** A hand on the pad and the path that it has made. */
class Hand {
  private path: HandAt[] | undefined;
  /** Place of the hand, px to the right and up from the middle. */
  private place = { right: 0, up: 0 };
  private pointer: { x: number; y: number } | undefined;
  private pause: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly form: SetupForm,
    private readonly pad: HTMLElement,
    private readonly dot: HTMLElement,
  ) {}

  begin(): void {
    const { clock } = this.form.lab;
    clock.pause();
    clock.rewind();
    this.path = [];
    this.go(0, 0);
  }

  from(x: number, y: number): void {
    this.pointer = { x, y };
  }

  /** Follows a pointer. */
  to(x: number, y: number): void {
    if (this.path && this.pointer) this.go(x - this.pointer.x, this.pointer.y - y);
  }

  /** Moves by a step to the right and up. */
  key(right: number, up: number): void {
    if (!this.path) this.begin();
    const from = this.place;
    this.go(from.right, from.up);
    this.go(from.right + KEY_STEP * right, from.up + KEY_STEP * up, KEY_TIME);
    clearTimeout(this.pause);
    this.pause = setTimeout(() => this.end(), 1000 * KEY_PAUSE);
  }

  /** Lets go: what was recorded is played. */
  end(): void {
    const { path, form } = this;
    this.path = this.pointer = undefined;
    form.lab.tableHeld.value = undefined;
    this.show(0, 0);
    const last = path?.at(-1);
    if (!path || !last || path.length < 3) return;
    const record = recordOf(path);
    const seconds = (record.length / 4) * STEP + AFTER;
    form.set("record", record);
    form.set("duration", Math.max(form.lab.setup.value.duration, Math.ceil(seconds)));
    form.letGo();
  }

  private go(right: number, up: number, after = 0): void {
    const { path, form } = this;
    if (!path) return;
    this.place = { right, up };
    this.show(right, up);
    const { azimuth } = form.lab;
    const [c, s] = [Math.cos(azimuth), Math.sin(azimuth)];
    const [x, y] = [SCALE * (-s * right - c * up), SCALE * (c * right - s * up)];
    form.lab.tableHeld.value = { x, y, z: 0 };
    const now = performance.now() / 1000 + after;
    // A key may be pressed before the step of the last one is over.
    const t = Math.max(now, (path.at(-1)?.t ?? 0) + 1e-3);
    path.push({ x, y, t });
    if (t - (path[0]?.t ?? t) > LONGEST) this.end();
  }

  /** Shows the hand, within the pad. */
  private show(right: number, up: number): void {
    const [wide, high] = [this.pad.clientWidth / 2, this.pad.clientHeight / 2];
    const within = (value: number, most: number) => Math.min(Math.max(value, -most), most);
    this.dot.style.translate = `${within(right, wide)}px ${within(-up, high)}px`;
  }
}
