// The playback controls: buttons and keys, a scrubber with marks of events, speed and time.

import { effect, type Signal, signal } from "@preact/signals-core";
import { element, type Icon, icon } from "../elements";
import { formatDuration, formatFixed, significant } from "../format";
import type { Lab } from "../lab";
import { speedName, SPEEDS } from "../setup/playback";
import { collisionsOf, nearest } from "../core/motion";
import "./transport.css";
import { soundButton } from "../sound/button";
import { say, words } from "../words/words";
import { shownPart } from "../part";

const texts = words.transport;

export function mountTransport(lab: Lab, place: HTMLElement): void {
  const { clock } = lab;
  const rewind = () => {
    clock.pause();
    clock.rewind();
  };
  const actions = {
    " ": unlessHeld(lab, () => clock.toggle()),
    ",": unlessHeld(lab, () => clock.step(-1)),
    ".": unlessHeld(lab, () => clock.step(1)),
    Home: unlessHeld(lab, rewind),
  };
  const play = button("play", texts.play, "Space", () => clock.toggle());
  const buttons = [
    button("rewind", texts.rewind, "Home", rewind),
    button("before", texts.before, "", () => jump(lab, -1)),
    button("back", texts.back, ",", actions[","]),
    play,
    button("on", texts.on, ".", actions["."]),
    button("after", texts.after, "", () => jump(lab, 1)),
  ];
  effect(() => {
    const playing = clock.playing.value;
    const name = playing ? texts.pause : texts.play;
    play.replaceChildren(icon(playing ? "pause" : "play"));
    play.setAttribute("aria-label", name);
    play.title = `${name} (${texts.space})`;
  });
  effect(() => {
    for (const one of buttons) one.disabled = lab.motion.value === undefined;
  });
  onKeys(actions);
  place.append(
    scrubber(lab),
    element(
      "div",
      { class: "row" },
      element(
        "div",
        { class: "buttons", role: "group", "aria-label": texts.group },
        ...buttons,
        soundButton(lab),
      ),
      readout(lab),
      element("div", { class: "pace" }, speed(lab), stretching(lab)),
    ),
    keys(),
  );
}

/** Ignores an action while a hand holds the body, so that no time passes. */
export const unlessHeld = (lab: Pick<Lab, "held">, act: () => void) => () => {
  if (!lab.held.peek()) act();
};

/** Goes to the next (1) or previous (-1) collision, or to that end of the motion. */
function jump(lab: Lab, way: 1 | -1): void {
  const motion = lab.motion.value;
  if (!motion) return;
  const { clock } = lab;
  const now = clock.time.value;
  const times = collisionsOf(motion).map((collision) => collision.t);
  const next =
    way > 0
      ? (times.find((time) => time > now) ?? motion.end)
      : (times.findLast((time) => time < now) ?? 0);
  clock.pause();
  clock.time.value = next;
}

function button(name: Icon, label: string, key: string, press: () => void): HTMLButtonElement {
  const shortcut = key === "" ? {} : { "aria-keyshortcuts": key };
  const title = key === "" ? label : `${label} (${key === "Space" ? texts.space : key})`;
  const made = element("button", { type: "button", "aria-label": label, title, ...shortcut });
  made.append(icon(name));
  made.classList.add(name);
  made.addEventListener("click", press);
  return made;
}

/** The readout, which is no live region because it changes with every frame. */
function readout(lab: Lab): HTMLElement {
  const time = element("strong");
  const since = element("span");
  const pace = element("span");
  effect(() => {
    const { clock } = lab;
    const motion = lab.motion.value;
    time.textContent = `${formatFixed(clock.time.value, 4)} s`;
    const collisions = motion ? collisionsOf(motion) : [];
    since.textContent = collisionText(
      clock.time.value,
      collisions[nearest(collisions, clock.time.value)]?.t,
    );
    pace.textContent = motion ? slowdownText(clock.slowdown) : "";
  });
  return element("p", { class: "readout" }, time, since, pace);
}

function speed(lab: Lab): HTMLElement {
  const select = element(
    "select",
    {},
    ...SPEEDS.map((one) => element("option", { value: String(one) }, speedName(one))),
  );
  select.addEventListener("change", () => (lab.clock.speed.value = Number(select.value)));
  effect(() => {
    select.value = String(lab.clock.speed.value);
  });
  return element("label", {}, `${words.playback.speed} `, select);
}

function stretching(lab: Lab): HTMLElement {
  const box = element("input", { type: "checkbox" });
  box.addEventListener("change", () => (lab.clock.stretched.value = box.checked));
  effect(() => {
    box.checked = lab.clock.stretched.value;
  });
  return element("label", { title: texts.stretching }, box, ` ${words.playback.slow}`);
}

/** The list of keys, and a switch that turns them off. */
function keys(): HTMLElement {
  const box = element("input", { type: "checkbox" });
  box.addEventListener("change", () => (keysOn.value = box.checked));
  effect(() => {
    box.checked = keysOn.value;
  });
  const key = (name: string, what: string) =>
    element("li", {}, element("kbd", {}, name), ` ${what}`);
  return element(
    "details",
    { class: "keys" },
    element("summary", {}, texts.keys),
    element(
      "ul",
      {},
      key(texts.space, texts.keyPlay),
      key(",", texts.keyBack),
      key(".", texts.keyOn),
      key("Home", texts.keyHome),
    ),
    element("label", {}, box, ` ${texts.keysOn}`),
  );
}

// A slider that goes to any time of the motion.

const ARROWS: Record<string, number> = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };
/** Frames that an arrow key with Shift moves. */
const LEAP = 10;

export function scrubber(lab: Lab): HTMLElement {
  const range = element("input", {
    type: "range",
    min: "0",
    max: "1",
    step: "any",
    value: "0",
    "aria-label": words.transport.shown,
  });
  range.addEventListener("input", () => {
    lab.clock.pause();
    lab.clock.progress = range.valueAsNumber;
  });
  range.addEventListener("keydown", (event) => {
    const frames = ARROWS[event.key];
    if (frames === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    lab.clock.step(event.shiftKey ? LEAP * frames : frames);
  });
  effect(() => {
    const { clock } = lab;
    range.disabled = lab.motion.value === undefined;
    range.value = String(clock.progress);
    range.style.setProperty("--part", String(clock.progress));
    // While the motion plays, a screen reader would read times without end.
    if (!clock.playing.value)
      range.setAttribute("aria-valuetext", timeText(clock.time.value, clock.end));
  });
  return element("div", { class: "scrubber" }, range, marks(lab));
}

// Writes the time shown and the speed in words.

/** The time (s) in a motion: 0.3214 s of 3 s. */
export function timeText(time: number, end: number): string {
  return say(words.transport.of, {
    time: `${formatFixed(time, 4)} s`,
    end: `${significant(end, 4)} s`,
  });
}

/** The time (s) relative to a collision (s): 12.3 µs before the collision. */
export function collisionText(time: number, collision: number | undefined): string {
  if (collision === undefined) return "";
  const since = time - collision;
  if (since === 0) return words.transport.atCollision;
  return say(words.transport.fromCollision, {
    time: formatDuration(Math.abs(since)),
    when: since < 0 ? "before" : "after",
  });
}

/** The speed compared with real time. */
export function slowdownText(slowdown: number): string {
  if (slowdown < 1.005) return words.transport.inRealTime;
  return say(words.transport.slower, { times: significant(slowdown, 2) });
}

// Keys that work anywhere in the lab, except in text fields and in controls that use them.

/** Whether the keys work; visitors who use speech input can switch them off. */
export const keysOn: Signal<boolean> = signal(true);

/** Elements that use keys themselves. */
const TYPED_IN =
  "input:not([type=range], [type=checkbox], [type=radio], [type=button]), select, textarea, [contenteditable], [role=textbox]";
const PRESSED = "button, summary, a[href], input, select, [role=button], [role=slider]";

export function onKeys(actions: Record<string, () => void>): void {
  addEventListener("keydown", (event) => {
    const act = actions[event.key];
    if (!act || !keysOn.value || event.defaultPrevented || shownPart() !== "lab") return;
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const target = event.target instanceof Element ? event.target : document.body;
    const punctuation = event.key === "," || event.key === ".";
    if (target.closest(punctuation ? TYPED_IN : `${TYPED_IN}, ${PRESSED}`)) return;
    act();
    // On Home the page also scrolls to its top, where the scene is.
    if (event.key !== "Home") event.preventDefault();
  });
}

// Marks of events under the scrubber.

/** Kinds of marks with their events, the more important kinds first. */
const KINDS: Record<string, readonly string[]> = {
  collision: ["tilt_min", "face_down", "topple"],
  grip: ["slip", "stick"],
  landing: ["lift_off", "land", "uplift", "stand"],
};

/** Smallest distance between two marks, as a fraction of the scrubber. */
const APART = 0.012;

export function marks(lab: Lab): HTMLElement {
  const all = element("div", { class: "marks", "aria-hidden": "true" });
  effect(() => {
    const events = lab.motion.value?.events ?? [];
    const placed = Object.values(KINDS).map((kinds) =>
      events
        .filter((event) => kinds.includes(event.kind))
        .map((event) => lab.clock.progressAt(event.moment.t)),
    );
    const names = Object.keys(KINDS);
    all.replaceChildren(
      ...apart(placed).flatMap((places, k) =>
        places.map((place) =>
          element("i", { class: names[k] as string, style: `--place: ${place.toFixed(5)}` }),
        ),
      ),
    );
  });
  return all;
}

/** Removes marks that are too close to an earlier mark or to one of a more important kind. */
export function apart(kinds: readonly (readonly number[])[]): number[][] {
  const taken = new Set<number>();
  const cell = (place: number) => Math.floor(place / APART);
  const free = (place: number) => ![-1, 0, 1].some((beside) => taken.has(cell(place) + beside));
  return kinds.map((places) =>
    places.filter((place) => {
      if (!free(place)) return false;
      taken.add(cell(place));
      return true;
    }),
  );
}
