// The playback controls: buttons, scrubber, speed and time.

import { effect } from "@preact/signals-core";
import { element } from "../elements";
import { formatFixed } from "../format/numbers";
import type { Lab } from "../lab";
import { SPEEDS, speedName } from "../setup/playback";
import { collisionsOf, nearest } from "../time/collisions";
import { type Icon, icon } from "./icons";
import { keysOn, onKeys } from "./keys";
import { collisionText, slowdownText } from "./readout";
import { scrubber } from "./scrubber";
import "./transport.css";
import { soundButton } from "../sound/button";
import { words } from "../words/words";

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
