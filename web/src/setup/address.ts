// Synchronises the address with the set-up and the step of the story.

import { batch, effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { LAB, partOf } from "../part";
import { prefersReducedMotion } from "../timing";
import { showStep, STEPS } from "../story/steps";
import { INITIAL } from "./setup";
import { fromHash, holdsSetup, inFull, toHash } from "./url";
import { choiceOf, say, words } from "../words/words";

/** Reads the set-up from the address, now and whenever the visitor edits it or goes back, and writes changes
 * back. A page that rimroll.lab makes has the set-up in its first element. */
export function keepInAddress(lab: Lab): void {
  const read = (link: string) => {
    if (partOf(link) === "lab" && holdsSetup(link)) readLink(lab, link);
  };
  read(location.hash || `#${document.documentElement.dataset["setup"] ?? ""}`);
  lab.beginHere();
  // Read the address of the event: a later one may have been written since.
  addEventListener("hashchange", ({ newURL }) => read(new URL(newURL).hash));
  let timer: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const hash = hashOf(lab);
    clearTimeout(timer);
    timer = setTimeout(() => write(hash), WRITE_DELAY);
  });
}

/** The set-up is written after this time without a change, ms: browsers refuse a hundred changes of the
 * address within a few seconds, and a slider makes more. */
const WRITE_DELAY = 200;

/** Sets the lab up as a link says. A link with a step alone shows what that step shows. */
export function readLink(lab: Lab, link: string): void {
  const { setup, playback, other, refusals } = fromHash(link);
  const pairs = new URLSearchParams(link.replace(/^#/, ""));
  const text = pairs.get("step");
  const step = STEPS.findIndex((_, k) => String(k + 1) === text);
  if (text !== null && step < 0)
    refusals.push({
      field: "step",
      text,
      message: say(words.refusals.noSuchChoice, {
        label: words.playback.step,
        ...choiceOf(STEPS.map((_, k) => String(k + 1))),
        text,
      }),
    });
  const known = [...pairs.keys()].some((name) => !["lab", "step", "embed"].includes(name));
  batch(() => {
    lab.refusals.value = refusals;
    lab.step.value = Math.max(step, 0);
    if (step >= 0 && !known) return;
    if (other || lab.otherSetup.value) lab.compare(other, setup);
    else lab.change(setup);
    lab.setPlayback(playback);
  });
  if (step >= 0 && !known) showStep(lab, STEPS[step]!, !prefersReducedMotion());
}

/** The # part of the address of what is shown; empty for what the lab opens with, whose address is {@link LAB}. */
export function hashOf(lab: Lab): string {
  const shows = [lab.setup.value, lab.playback, lab.otherSetup.value] as const;
  const step = lab.step.value;
  const shown = STEPS[step];
  if (step === 0 || !shown) return toHash(...shows);
  const hash = inFull(...shows);
  const untouched = hash === inFull({ ...INITIAL, ...shown.setup }, shown);
  // A step alone would show its own set-up.
  return `step=${step + 1}${untouched ? "" : `&${hash}`}`;
}

/** Goes to a step of the story and shows it, as a new entry of the history. */
export function goToStep(lab: Lab, step: number, moving: boolean): void {
  const shown = STEPS[step];
  if (!shown) return;
  write(hashOf(lab));
  lab.step.value = step;
  showStep(lab, shown, moving);
  write(hashOf(lab), true);
}

function write(hash: string, anew = false): void {
  // A page that another one holds as a text has no address of its own.
  if (location.protocol === "about:") return;
  if (partOf(location.hash) !== "lab") return;
  const whole = [EMBED && "embed", hash].filter(Boolean).join("&") || LAB;
  if (whole === location.hash.replace(/^#/, "")) return;
  const address = `#${whole}`;
  // Moves of a slider make no entries in the history.
  if (anew) history.pushState(null, "", address);
  else history.replaceState(null, "", address);
}

/** Whether the page is shown small, in a frame of another page. */
export const EMBED = typeof location !== "undefined" && /[#&]embed(=1)?(&|$)/.test(location.hash);
