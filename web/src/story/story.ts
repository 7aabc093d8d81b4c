// The story: a card with one of six steps, which sets the lab up and plays the motion.

import { effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { prefersReducedMotion } from "../timing";
import { goToStep } from "../setup/address";
import { fallsOf } from "../falls/humps";
import { showStep, type Step, STEPS } from "./steps";
import "./story.css";
import { say, words } from "../words/words";

export function mountStory(lab: Lab, place: HTMLElement): void {
  const { story } = words;
  place.innerHTML = `
    <p class="where"></p>
    <div aria-live="polite"><h2></h2><p class="text"></p><p class="formula"></p><p class="symbols"></p></div>
    <div class="row">
      <button type="button" class="back" aria-label="${story.backLabel}">${story.back}</button>
      <button type="button" class="show primary">${story.show}</button>
      <button type="button" class="next" aria-label="${story.nextLabel}">${story.next}</button>
    </div>`;
  const part = <E extends HTMLElement>(selector: string) => place.querySelector(selector) as E;
  const at = lab.step;
  const step = () => STEPS[at.value] as Step;
  // With reduced motion nothing plays until the visitor presses the button.
  const go = (by: 1 | -1) => goToStep(lab, at.value + by, !prefersReducedMotion());
  const flicks = () => step().shows === "flicks";
  const falls = fallsOf(lab, flicks);
  part(".row").before(falls);
  part(".back").addEventListener("click", () => go(-1));
  part(".show").addEventListener("click", () => showStep(lab, step(), true));
  part(".next").addEventListener("click", () => go(1));
  effect(() => {
    falls.hidden = !flicks();
  });
  effect(() => {
    const { title, text, formula = "", symbols = "" } = step();
    part(".formula").innerHTML = formula;
    part(".symbols").textContent = symbols;
    part(".where").textContent = say(story.where, { step: at.value + 1, of: STEPS.length });
    part("h2").textContent = title;
    part(".text").textContent = text;
    // A disabled button would lose the focus after it is pressed.
    part(".back").setAttribute("aria-disabled", String(at.value === 0));
    part(".next").setAttribute("aria-disabled", String(at.value === STEPS.length - 1));
  });
}
