// The section on what the model leaves out, with the numbers of the motion shown.

import { computed, effect } from "@preact/signals-core";
import { element } from "../elements";
import type { Lab } from "../lab";
import { shownPassage } from "../verdict/passage";
import "./limits.css";
import { unevennessChoice } from "./unevenness";
import { limitsOf } from "./words";
import { words } from "../words/words";

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
