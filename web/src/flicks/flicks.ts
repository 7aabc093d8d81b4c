// The panel of the flicks: a button repeats the release, and the falls appear one after the other.

import { effect } from "@preact/signals-core";
import { clearFlicks, startFlicks } from "../falls/animation";
import { tallyOf } from "../falls/tally";
import { flickSummary } from "../falls/summary";
import { SetupForm } from "../inputs/setup_form";
import { numberRow } from "../inputs/number";
import type { Lab } from "../lab";
import { FLICK_FIELDS } from "../setup/fields";
import "./flicks.css";
import { histogram } from "./histogram";

export function mountFlicks(lab: Lab, place: HTMLElement): void {
  place.innerHTML = `
    <h2>Forty-two flicks</h2>
    <p class="hint">No hand repeats a motion exactly. Repeat this release with some scatter and see where the body falls.</p>
    <div class="row">
      <button type="button" class="make primary"></button>
      <button type="button" class="clear">Clear</button>
    </div>
    <details><summary>The hand</summary></details>
    <figure>
      <svg viewBox="-106 -106 212 212" role="img" aria-label="Directions in which the body fell, seen from above" aria-describedby="flicks-said"></svg>
      <figcaption>
        <p id="flicks-said" role="status"></p>
        <ul class="legend">
          <li><i class="left"></i>to the left of the hand</li>
          <li><i class="right"></i>to the right</li>
          <li><i class="no-slip"></i>limit without slip <b class="no-slip-limit"></b></li>
          <li><i class="frictionless"></i>limit without friction <b class="frictionless-limit"></b></li>
          <li class="for-here"><i class="here"></i>limit on this table <b class="here-limit"></b></li>
          <li class="for-measured"><i class="measured"></i>the paper: 213.0 ± 3.9° and 217.9 ± 4.5°</li>
        </ul>
        <p class="hint for-twisted">The limits hold for a body that is not twisted.</p>
      </figcaption>
    </figure>`;
  const part = <E extends Element>(selector: string) => place.querySelector(selector) as E;
  const make = part<HTMLButtonElement>(".make");
  const clear = part<HTMLButtonElement>(".clear");
  const picture = part<SVGElement>("svg");
  const said = part<HTMLElement>("#flicks-said");

  make.addEventListener("click", () => {
    // Each repetition has another seed, which the link holds.
    if (lab.flicksShown.value !== undefined) lab.change({ seed: nextSeed(lab) });
    startFlicks(lab);
  });
  clear.addEventListener("click", () => {
    clearFlicks(lab);
    // This button disappears, so the focus must move.
    make.focus();
  });
  const form = new SetupForm(lab);
  const details = part<HTMLDetailsElement>("details");
  details.append(...FLICK_FIELDS.map((name) => numberRow(form, name).row));
  effect(() => {
    const refused = lab.refusals.value.some(({ field }) =>
      (FLICK_FIELDS as readonly string[]).includes(field),
    );
    if (refused) details.open = true;
  });

  effect(() => {
    const { flicks } = lab.setup.value;
    const again = lab.flicksShown.value !== undefined;
    make.textContent =
      flicks === 1 ? "Flick it once" : `Flick it ${flicks} times${again ? " again" : ""}`;
    clear.hidden = !again;
  });
  effect(() => {
    const text = flickSummary(lab);
    // An unchanged text must not be read out again.
    if (said.textContent !== text) said.textContent = text;
  });
  effect(() => {
    const { body, twist } = lab.setup.value;
    const tally = tallyOf(lab.flicks.value.slice(0, lab.flicksShown.value ?? 0));
    const theory = lab.theory.value;
    const measured = body === "can_2007";
    picture.innerHTML = histogram({ tally, theory, measured });
    part<HTMLElement>(".for-twisted").hidden = twist === 0;
    part<HTMLElement>(".for-measured").hidden = !measured;
    part<HTMLElement>(".for-here").hidden = !theory || Number.isNaN(theory.here);
    for (const [name, limit] of [
      ["no-slip", theory?.noSlip],
      ["frictionless", theory?.frictionless],
      ["here", theory?.here],
    ] as const)
      part<HTMLElement>(`.${name}-limit`).textContent = limit === undefined ? "" : degrees(limit);
  });
}

const nextSeed = (lab: Lab) => (lab.setup.value.seed + 1) % 4294967296;

const degrees = (radians: number) => `${((radians * 180) / Math.PI).toFixed(1)}°`;
