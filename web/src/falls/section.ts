// The section of the flicks: a button repeats the release, and the falls appear one after the other. Below are the visitor's own falls.

import { computed, effect } from "@preact/signals-core";
import { clearFlicks, flickSummary, inWords, startFlicks } from "./shown";
import { fallsFromLink, fallsInLink, fallsTyped, MEASURED, tallyOf, tallyOfFalls } from "./tally";
import { SetupForm } from "../controls/setup_form";
import { numberRow } from "../controls/inputs";
import type { Lab } from "../lab";
import { FLICK_FIELDS } from "../setup/fields";
import "./flicks.css";
import { histogram } from "./histogram";
import { formatDegrees, formatFixed } from "../format";
import { say, words } from "../words/words";
import { button, element, svgElement } from "../elements";
import { fitted, type Measured } from "./fit";
import { binsFor, HEIGHT, humps, WIDTH } from "./humps";

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

// Falls that visitors measured themselves: typed, pooled with those of other groups by their links, and kept in the link.

export function ownFalls(lab: Lab): HTMLElement {
  const { own } = words.flicks;
  const typed = element("textarea", { id: "own-falls", rows: 2, spellcheck: "false" });
  const refusal = element("p", { class: "refusal", role: "alert" });
  const add = button(own.add, () => {
    const more = fallsTyped(typed.value);
    refusal.textContent = more ? "" : own.refused;
    if (!more) return;
    lab.change({ falls: fallsInLink([...directions.value, ...more]) });
    typed.value = "";
  });
  const clear = button(own.clear, () => {
    lab.change({ falls: "" });
    typed.focus();
  });
  const picture = svgElement("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img" });
  const said = element("p", { role: "status" });
  const directions = computed(() => fallsFromLink(lab.setup.value.falls));
  const tally = computed(() => tallyOfFalls(directions.value));
  const measured = (): Measured | undefined =>
    Math.max(tally.value.left.count, tally.value.right.count) < 2 ? undefined : tally.value;
  const result = element(
    "div",
    { class: "result falls" },
    picture as unknown as HTMLElement,
    said,
    fitted(lab.core, () => lab.setup.value, measured),
  );
  const details = element(
    "details",
    { class: "own-falls" },
    element("summary", {}, own.title),
    element("label", { for: typed.id, class: "hint" }, own.help),
    typed,
    refusal,
    element("div", { class: "row" }, add, clear),
    result,
  );
  effect(() => {
    const theory = lab.theory.value;
    const { left, right } = tally.value;
    result.hidden = clear.hidden = directions.value.length === 0;
    if (result.hidden) return;
    details.open = true;
    const bins = binsFor(theory, [...left.turns, ...right.turns]);
    picture.innerHTML = humps({ tally: tally.value, theory, bins, measured: false });
    said.textContent = inWords(tally.value, directions.value.length);
    picture.setAttribute("aria-label", said.textContent);
  });
  return details;
}
