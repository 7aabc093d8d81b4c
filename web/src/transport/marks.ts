// Marks under the scrubber where something happens.

import { effect } from "@preact/signals-core";
import { drawn } from "../elements";
import type { Lab } from "../lab";

/** Kinds of marks, each with the events that it stands for. */
const KINDS: Record<string, readonly string[]> = {
  collision: ["tilt_min", "face_down", "topple"],
  grip: ["slip", "stick"],
  landing: ["lift_off", "land"],
};

export function marks(lab: Lab): SVGElement {
  const paths = Object.keys(KINDS).map((kind) =>
    drawn("path", { class: kind, "vector-effect": "non-scaling-stroke" }),
  );
  effect(() => {
    const events = lab.motion.value?.events ?? [];
    Object.values(KINDS).forEach((kinds, k) => {
      const places = events
        .filter((event) => kinds.includes(event.kind))
        .map((event) => lab.clock.progressAt(event.moment.t).toFixed(5));
      // Many at one place are one mark.
      const lines = [...new Set(places)].map((place) => `M${place} 0V1`);
      paths[k]?.setAttribute("d", lines.join(""));
    });
  });
  return drawn(
    "svg",
    { class: "marks", viewBox: "0 0 1 1", preserveAspectRatio: "none", "aria-hidden": "true" },
    ...paths,
  );
}
