// The choice of a roughness, and what it means for the turn that is shown.

import { type ReadonlySignal, effect, signal } from "@preact/signals-core";
import { element } from "../elements";
import { formatDegrees } from "../format/numbers";
import { formatDuration } from "../format/times";
import type { Lab } from "../lab";
import type { Passage } from "../verdict/passage";
import { words } from "../words/words";
import { touching } from "./touching";

/** Heights of roughness, m. */
const HEIGHTS = { polished: 1e-7, smooth: 1e-6, turned: 3e-6, rough: 1e-5, coarse: 1e-4 } as const;
type Roughness = keyof typeof HEIGHTS;

export function roughnessChoice(
  lab: Lab,
  passage: ReadonlySignal<Passage | undefined>,
): HTMLElement {
  const chosen = signal<Roughness>("turned");
  const { roughness, roughnesses } = words.limits;
  const select = element(
    "select",
    { id: "roughness" },
    ...Object.keys(HEIGHTS).map((name) =>
      element("option", { value: name }, roughnesses[name as Roughness]),
    ),
  );
  select.value = chosen.value;
  select.addEventListener("change", () => (chosen.value = select.value as Roughness));
  const means = element("p", { class: "means", role: "status" });
  const place = element(
    "div",
    { class: "roughness" },
    element("label", { for: select.id }, roughness),
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
  return words.limits.touches(
    formatDuration(near.time),
    formatDegrees(near.angle, 0),
    formatDegrees(Math.abs(angle), 0),
  );
}
