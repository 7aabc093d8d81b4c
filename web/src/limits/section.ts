// The section on what the model leaves out, with the numbers of the motion shown.

import { computed, effect, type ReadonlySignal, signal } from "@preact/signals-core";
import { element } from "../elements";
import type { Lab } from "../lab";
import { type Passage, shownPassage } from "../verdict/passage";
import "./limits.css";
import { entryOf, limitsOf, touching } from "./limits";
import { say, words } from "../words/words";
import { formatDegrees, formatDuration } from "../format";

export function mountLimits(lab: Lab, place: HTMLElement): void {
  const passage = shownPassage(lab);
  const limits = computed(() => (passage.value ? limitsOf(passage.value.validity) : []));
  const list = element("dl");
  const none = element("p", { class: "hint" }, words.limits.none);
  place.append(
    element("h2", {}, words.limits.title),
    element("p", {}, words.limits.intro),
    list,
    unevennessChoice(lab, passage),
    none,
    element("p", {}, words.limits.trust),
  );
  effect(() => {
    none.hidden = limits.value.length > 0;
    list.replaceChildren(...limits.value.map(entryOf));
  });
}

// The choice of an unevenness, and what it means for the turn that is shown.

/** Heights of unevenness, m: a ground face, the general tolerances H, K and L for the flatness of faces 30 to 100 mm across
 * (ISO 2768-2), and a dent. */
const HEIGHTS = { ground: 2e-5, fine: 1e-4, medium: 2e-4, coarse: 4e-4, dented: 1e-3 } as const;
type Unevenness = keyof typeof HEIGHTS;

export function unevennessChoice(
  lab: Lab,
  passage: ReadonlySignal<Passage | undefined>,
): HTMLElement {
  const chosen = signal<Unevenness>("fine");
  const { unevenness, unevennesses } = words.limits;
  const select = element(
    "select",
    { id: "unevenness" },
    ...Object.keys(HEIGHTS).map((name) =>
      element("option", { value: name }, unevennesses[name as Unevenness]),
    ),
  );
  select.value = chosen.value;
  select.addEventListener("change", () => (chosen.value = select.value as Unevenness));
  const means = element("p", { class: "means", role: "status" });
  const place = element(
    "div",
    { class: "unevenness" },
    element("label", { for: select.id }, unevenness),
    select,
    means,
  );
  effect(() => {
    const outcome = lab.outcome.value;
    place.hidden = !passage.value || !("motion" in outcome);
    if (!passage.value || !("motion" in outcome)) return;
    const { motion, input } = outcome;
    const text = inWords(
      passage.value,
      touching(motion, passage.value, input.body.radius, HEIGHTS[chosen.value]),
    );
    // An unchanged text must not be read out again.
    if (means.textContent !== text) means.textContent = text;
  });
  return place;
}

function inWords({ angle }: Passage, near: ReturnType<typeof touching>): string {
  if (!near) return words.limits.touchesOnce;
  return say(words.limits.touches, {
    time: formatDuration(near.time),
    angle: formatDegrees(near.angle, 0),
    whole: formatDegrees(Math.abs(angle), 0),
  });
}
