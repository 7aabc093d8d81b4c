// What happens, in big numbers and in words: the angle of turn beside the theory's.

import { computed, effect } from "@preact/signals-core";
import { element } from "../elements";
import { degrees } from "../inputs/shown";
import { type Lab, ownBeside } from "../lab";
import { ofHand } from "./held";
import { ofMotion } from "./moving";
import { passageFrom } from "./passage";

/** s without a change after which the words are read out; not while it moves. */
const SETTLED = 0.8;

/** Tiles whose numbers change with every picture. */
const TICKING = ["turned", "itself"] as const;

export function mountVerdict(lab: Lab, place: HTMLElement): void {
  const start = computed(() => lab.turning.value?.start);
  const passage = computed(() => {
    const motion = lab.motion.value;
    return motion && start.value !== undefined ? passageFrom(motion, start.value) : undefined;
  });

  const told = computed(() => {
    const seen = lab.foreseen.value;
    return seen ? ofHand(seen, lab.setup.value) : ofMotion(lab, passage.value);
  });
  const words = computed(() => `${told.value.said} ${told.value.ended}`.trim());

  const tiles = { turned: tile(), itself: tile(), theory: tile(), lowest: tile(), then: tile() };
  const said = element("p", { class: "said" });
  const ended = element("p", { class: "ended" });
  const heard = element("p", { class: "unseen", role: "status" });
  const numbers = element("dl");
  for (const [kind, { all }] of entries(tiles)) {
    all.className = kind;
    numbers.append(all);
  }
  place.append(numbers, element("div", { class: "words" }, said, ended), heard);

  // These tick, so they are not read out; the whole of them, in words, is.
  for (const kind of TICKING) tiles[kind].number.setAttribute("aria-hidden", "true");
  effect(() => {
    const turning = lab.turning.value;
    const ticking = {
      turned: turning ? degrees(Math.abs(turning.angle), 1) : "–",
      itself: turning ? degrees(ownBeside(turning), 1) : "–",
    };
    for (const kind of TICKING)
      tiles[kind].number.textContent = lab.foreseen.value ? told.value[kind].number : ticking[kind];
  });
  effect(() => {
    numbers.hidden = lab.motion.value === undefined && !lab.foreseen.value;
    // What is not yet so looks otherwise than what is.
    place.classList.toggle("foreseen", lab.foreseen.value !== undefined);
    for (const [kind, { name, number, note }] of entries(tiles)) {
      const now = told.value[kind];
      name.textContent = now.name;
      if (!(TICKING as readonly string[]).includes(kind)) number.textContent = now.number;
      note.textContent = now.note;
    }
    said.textContent = told.value.said;
    ended.textContent = told.value.ended;
    ended.classList.toggle("amiss", told.value.amiss);
  });
  effect(() => {
    const text = words.value;
    if (lab.clock.playing.value) return undefined;
    const settled = setTimeout(() => hear(heard, text), 1000 * SETTLED);
    return () => clearTimeout(settled);
  });
}

const entries = <K extends string, V>(of: Record<K, V>) => Object.entries(of) as [K, V][];

/** The same words again are not read out again. */
function hear(place: HTMLElement, text: string): void {
  if (place.textContent !== text) place.textContent = text;
}

function tile() {
  const name = element("dt");
  const number = element("dd", { class: "big" });
  const note = element("dd", { class: "note" });
  return { all: element("div", {}, name, number, note), name, number, note };
}
