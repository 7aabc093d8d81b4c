// The verdict: the angle of turn and the theory's in large numbers, and the motion in words.

import { computed, effect } from "@preact/signals-core";
import { element } from "../elements";
import { formatDegrees } from "../format";
import { bodyAngleAlongContact, type Lab } from "../lab";
import { contentInHand, contentInMotion } from "./tiles";
import { shownPassage } from "./passage";
import { sentences } from "../words/words";

/** The words are read out after this time without a change, s, and not while the motion plays. */
const READ_DELAY = 0.8;

/** Tiles whose numbers change with every frame. */
const LIVE = ["turned", "itself"] as const;

export function mountVerdict(lab: Lab, place: HTMLElement): void {
  const passage = shownPassage(lab);
  const content = computed(() => {
    const preview = lab.preview.value;
    return preview ? contentInHand(preview, lab.setup.value) : contentInMotion(lab, passage.value);
  });
  const spoken = computed(() => sentences(content.value.said, content.value.ended));

  const tiles = { turned: tile(), itself: tile(), theory: tile(), lowest: tile(), then: tile() };
  const said = element("p", { class: "said" });
  const ended = element("p", { class: "ended" });
  const announcement = element("p", { class: "unseen", role: "status" });
  const numbers = element("dl");
  for (const [kind, { all }] of entries(tiles)) {
    all.className = kind;
    numbers.append(all);
  }
  place.append(numbers, element("div", { class: "words" }, said, ended), announcement);

  // Screen readers skip the changing numbers and read the complete turn in words.
  for (const kind of LIVE) tiles[kind].number.setAttribute("aria-hidden", "true");
  effect(() => {
    const turning = lab.turnProgress.value;
    const live = {
      turned: turning ? formatDegrees(Math.abs(turning.angle), 1) : "–",
      itself: turning ? formatDegrees(bodyAngleAlongContact(turning), 1) : "–",
    };
    for (const kind of LIVE)
      tiles[kind].number.textContent = lab.preview.value ? content.value[kind].number : live[kind];
  });
  effect(() => {
    numbers.hidden = lab.motion.value === undefined && !lab.preview.value;
    // A preview looks different from a motion.
    place.classList.toggle("preview", lab.preview.value !== undefined);
    for (const [kind, { name, number, note }] of entries(tiles)) {
      const now = content.value[kind];
      name.textContent = now.name;
      if (!(LIVE as readonly string[]).includes(kind)) number.textContent = now.number;
      note.textContent = now.note;
    }
    said.textContent = content.value.said;
    ended.replaceChildren(...markedEnglish(content.value.ended, content.value.english));
    ended.classList.toggle("abnormal", content.value.abnormal);
  });
  effect(() => {
    const text = spoken.value;
    if (lab.clock.playing.value) return undefined;
    const timer = setTimeout(() => announce(announcement, text), 1000 * READ_DELAY);
    return () => clearTimeout(timer);
  });
}

const entries = <K extends string, V>(of: Record<K, V>) => Object.entries(of) as [K, V][];

/** Sets a text that screen readers read out; an unchanged text is not read again. */
function announce(place: HTMLElement, text: string): void {
  if (place.textContent !== text) place.textContent = text;
}

/** A text whose English part is marked, so that screen readers pronounce it as such. */
function markedEnglish(text: string, english: string): (Node | string)[] {
  const at = english === "" ? -1 : text.indexOf(english);
  if (at < 0) return [text];
  const marked = element("span", { lang: "en" }, english);
  return [text.slice(0, at), marked, text.slice(at + english.length)];
}

function tile() {
  const name = element("dt");
  const number = element("dd", { class: "big" });
  const note = element("dd", { class: "note" });
  return { all: element("div", {}, name, number, note), name, number, note };
}
