// The story: a card with one step of six, which sets the lab up and shows it.

import { effect, signal } from "@preact/signals-core";
import { makeThem } from "../flicks/making";
import type { Lab } from "../lab";
import { INITIAL } from "../setup/setup";
import { STEPS, type Step } from "./steps";
import "./story.css";

export function mountStory(lab: Lab, place: HTMLElement): void {
  place.innerHTML = `
    <p class="where"></p>
    <div aria-live="polite"><h2></h2><p class="text"></p></div>
    <div class="row">
      <button type="button" class="back" aria-label="Back, to the step before">‹ Back</button>
      <button type="button" class="show primary">Show me</button>
      <button type="button" class="next" aria-label="Next step">Next ›</button>
    </div>`;
  const part = <E extends HTMLElement>(selector: string) => place.querySelector(selector) as E;
  const at = signal(0);
  const go = (step: number) => {
    at.value = step;
    show(lab, STEPS[step] as Step);
  };
  part(".back").addEventListener("click", () => go(at.value - 1));
  part(".show").addEventListener("click", () => go(at.value));
  part(".next").addEventListener("click", () => go(at.value + 1));
  effect(() => {
    const step = STEPS[at.value] as Step;
    part(".where").textContent = `The story, step ${at.value + 1} of ${STEPS.length}`;
    part("h2").textContent = step.title;
    part(".text").textContent = step.text;
    part<HTMLButtonElement>(".back").disabled = at.value === 0;
    part<HTMLButtonElement>(".next").disabled = at.value === STEPS.length - 1;
  });
}

/** Sets the lab up for a step and lets it happen. */
function show(lab: Lab, step: Step): void {
  lab.flicksMade.value = undefined;
  lab.change({ ...INITIAL, ...step.setup });
  lab.clock.speed.value = step.speed;
  lab.clock.stretched.value = step.stretched;
  if (step.shows === "flicks") makeThem(lab);
  lab.clock.play();
}
