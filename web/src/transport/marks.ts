// Marks under the scrubber where something happens.

import { effect } from "@preact/signals-core";
import { element } from "../elements";
import type { Lab } from "../lab";

/** Kinds of marks, each with the events that it stands for; the first are the more important. */
const KINDS: Record<string, readonly string[]> = {
  collision: ["tilt_min", "face_down", "topple"],
  grip: ["slip", "stick"],
  landing: ["lift_off", "land"],
};

/** Closer together than this, in parts of the whole, two marks would be a smudge. */
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

/** Without those that are too close to one before them, or to one of a kind before theirs. */
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
