// The section on what the model leaves out, with the numbers of the motion shown.

import { computed, effect } from "@preact/signals-core";
import { element } from "../elements";
import type { Lab } from "../lab";
import { shownPassage } from "../verdict/passage";
import "./limits.css";
import { limitsOf } from "./words";

export function mountLimits(lab: Lab, place: HTMLElement): void {
  const passage = shownPassage(lab);
  const limits = computed(() => (passage.value ? limitsOf(passage.value.validity) : []));
  const list = element("dl");
  const none = element(
    "p",
    { class: "hint" },
    "This body does not come down, so there is nothing to compare.",
  );
  place.append(
    element("h2", {}, "What this model leaves out"),
    element(
      "p",
      {},
      "Body and table are perfectly rigid and smooth here, the rim is a perfect circle, and there is no air. In the turn that is shown:",
    ),
    list,
    none,
    element(
      "p",
      {},
      "Where a number is beyond a real body, do not trust the gap or the speed. Trust the angle, which hardly depends on how small the gap gets. A hand makes a sideways error of about 0.02 rad/s.",
    ),
  );
  effect(() => {
    none.hidden = limits.value.length > 0;
    list.replaceChildren(
      ...limits.value.map(({ name, here, means, exceeded }) =>
        element(
          "div",
          { class: exceeded ? "exceeded" : "held" },
          element("dt", {}, name),
          element("dd", { class: "here" }, here),
          element("dd", { class: "means" }, means),
        ),
      ),
    );
  });
}
