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
import { ownFalls } from "./own_falls";
import { MEASURED } from "../falls/paper";
import { formatDegrees, formatFixed } from "../format/numbers";
import { say, words } from "../words/words";

export function mountFlicks(lab: Lab, place: HTMLElement): void {
  const { flicks: text } = words;
  place.innerHTML = `
    <h2>${text.title}</h2>
    <p class="hint">${text.hint}</p>
    <div class="row">
      <button type="button" class="make primary"></button>
      <button type="button" class="clear">${text.clear}</button>
    </div>
    <details><summary>${text.hand}</summary></details>
    <figure>
      <svg viewBox="-106 -106 212 212" role="img" aria-label="${text.picture}" aria-describedby="flicks-said"></svg>
      <figcaption>
        <p id="flicks-said" role="status"></p>
        <ul class="legend">
          <li><i class="left"></i>${text.left}</li>
          <li><i class="right"></i>${text.right}</li>
          <li><i class="no-slip"></i>${text.noSlip} <b class="no-slip-limit"></b></li>
          <li><i class="frictionless"></i>${text.frictionless} <b class="frictionless-limit"></b></li>
          <li class="for-here"><i class="here"></i>${text.here} <b class="here-limit"></b></li>
          <li class="for-measured"><i class="measured"></i>${say(text.measured, { left: measuredAngle("left"), right: measuredAngle("right") })}</li>
        </ul>
        <p class="hint for-twisted">${text.twisted}</p>
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
  details.append(
    ...(["flicks", "unsteadiness", "seed"] as const).map((name) => numberRow(form, name).row),
  );
  effect(() => {
    const refused = lab.refusals.value.some(({ field }) =>
      (FLICK_FIELDS as readonly string[]).includes(field),
    );
    if (refused) details.open = true;
  });

  place.append(ownFalls(lab));

  effect(() => {
    const { flicks } = lab.setup.value;
    const again = lab.flicksShown.value !== undefined;
    make.textContent =
      again && flicks > 1
        ? say(words.flickAgain, { count: flicks })
        : say(words.flickTimes, { count: flicks });
    clear.hidden = !again;
  });
  effect(() => {
    const summary = flickSummary(lab);
    // An unchanged text must not be read out again.
    if (said.textContent !== summary) said.textContent = summary;
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

const degrees = (radians: number) => formatDegrees(radians, 1);

const measuredAngle = (side: keyof typeof MEASURED) =>
  `${formatFixed(MEASURED[side].mean, 1)} ± ${formatFixed(MEASURED[side].deviation, 1)}°`;
