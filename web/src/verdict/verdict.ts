// What happens, in big numbers and in words: the angle of turn beside the theory's.

import { computed, effect } from "@preact/signals-core";
import { element } from "../elements";
import { degrees, shownWide } from "../inputs/shown";
import type { Lab } from "../lab";
import { passageFrom } from "./passage";
import { comparison, ending, inAll, story } from "./words";

/** s without a change after which the words are read out; not while it moves. */
const SETTLED = 0.8;

export function mountVerdict(lab: Lab, place: HTMLElement): void {
  const start = computed(() => lab.turning.value?.start);
  const passage = computed(() => {
    const motion = lab.motion.value;
    return motion && start.value !== undefined ? passageFrom(motion, start.value) : undefined;
  });

  const turned = tile("Angle of turn", "turned");
  const theory = tile("In theory", "theory");
  const lowest = tile("Flattest", "lowest");
  const fastest = tile("Contact point", "fastest");
  const said = element("p", { class: "said" });
  const ended = element("p", { class: "ended" });
  const heard = element("p", { class: "unseen", role: "status" });
  const numbers = element("dl", {}, turned.all, theory.all, lowest.all, fastest.all);
  place.append(numbers, element("div", { class: "words" }, said, ended), heard);

  // It ticks, so it is not read out; the whole of it, beside, is.
  turned.number.setAttribute("aria-hidden", "true");
  effect(() => {
    const angle = lab.turning.value?.angle;
    turned.number.textContent = angle === undefined ? "–" : degrees(Math.abs(angle), 1);
  });
  effect(() => {
    const now = passage.value;
    numbers.hidden = lab.motion.value === undefined;
    turned.note.textContent = inAll(now, lab.motion.value);
    theory.number.textContent = degrees(lab.theory.value?.here ?? NaN, 2);
    theory.note.textContent = comparison(now, lab.theory.value, lab.setup.value);
    const tilt = now && (now.minTilt * 180) / Math.PI;
    lowest.number.textContent = tilt === undefined ? "–" : `${shownWide(tilt, 2)}°`;
    lowest.note.textContent = "smallest tilt";
    const revolutions = now && Math.abs(now.yawRate) / (2 * Math.PI);
    fastest.number.textContent = revolutions === undefined ? "–" : shownWide(revolutions, 3);
    fastest.note.textContent = "turns a second there";
  });
  effect(() => {
    const setup = lab.setup.value;
    said.textContent = story(passage.value, setup);
    ended.textContent = ending(lab.outcome.value, setup);
    const amiss = ["face_down", "painleve", "failed", "lifted_off"];
    const status = lab.motion.value?.status;
    ended.classList.toggle("amiss", status === undefined || amiss.includes(status));
  });
  effect(() => {
    const text = [
      story(passage.value, lab.setup.value),
      ending(lab.outcome.value, lab.setup.value),
    ];
    if (lab.clock.playing.value) return undefined;
    const settled = setTimeout(() => hear(heard, text.join(" ").trim()), 1000 * SETTLED);
    return () => clearTimeout(settled);
  });
}

/** The same words again are not read out again. */
function hear(place: HTMLElement, text: string): void {
  if (place.textContent !== text) place.textContent = text;
}

function tile(name: string, kind: string) {
  const number = element("dd", { class: "big" });
  const note = element("dd", { class: "note" });
  const all = element("div", { class: kind }, element("dt", {}, name), number, note);
  return { all, number, note };
}
