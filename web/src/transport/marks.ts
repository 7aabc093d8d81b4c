// Marks of events under the scrubber.

import { effect } from "@preact/signals-core";
import { element } from "../elements";
import type { Lab } from "../lab";

/** Kinds of marks with their events, the more important kinds first. */
const KINDS: Record<string, readonly string[]> = {
  collision: ["tilt_min", "face_down", "topple"],
  grip: ["slip", "stick"],
  landing: ["lift_off", "land", "uplift", "stand"],
};

/** Smallest distance between two marks, as a fraction of the scrubber. */
const APART = 0.012;

export function marks(lab: Lab): HTMLElement {
  const all = element("div", { class: "marks", "aria-hidden": "true" });
  effect(() => {
    const events = lab.motion.value?.events ?? [];
    const placed = Object.values(KINDS).map((kinds) =>
      events
        .filter((event) => kinds.includes(event.kind))
        .map((event) => lab.clock.progressAt(event.moment.t)),
    );
    const names = Object.keys(KINDS);
    all.replaceChildren(
      ...apart(placed).flatMap((places, k) =>
        places.map((place) =>
          element("i", { class: names[k] as string, style: `--place: ${place.toFixed(5)}` }),
        ),
      ),
    );
  });
  return all;
}

/** Removes marks that are too close to an earlier mark or to one of a more important kind. */
export function apart(kinds: readonly (readonly number[])[]): number[][] {
  const taken = new Set<number>();
  const cell = (place: number) => Math.floor(place / APART);
  const free = (place: number) => ![-1, 0, 1].some((beside) => taken.has(cell(place) + beside));
  return kinds.map((places) =>
    places.filter((place) => {
      if (!free(place)) return false;
      taken.add(cell(place));
      return true;
    }),
  );
}
