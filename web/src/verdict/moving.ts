// What is said of a motion: the whole of the turn that is shown, in the present tense, as it is true
// at any time in it.

import { degrees, shownWide } from "../inputs/shown";
import { BODY_NOUNS } from "../setup/fields";
import type { Lab } from "../lab";
import type { Passage } from "./passage";
import { gapOf, speedOf } from "./size";
import type { Told } from "./told";
import { comparison, ending, inThisTurn, story } from "./words";

/** Endings that want explaining. */
const AMISS: readonly string[] = ["face_down", "painleve", "failed", "lifted_off"];

/** There is no motion. */
const NONE = { motion: undefined, theory: undefined, begun: false };

export function ofMotion(lab: Lab, passage: Passage | undefined): Told {
  const [setup, outcome] = [lab.setup.value, lab.outcome.value];
  const { motion, theory, begun } = "motion" in outcome ? outcome : NONE;
  const radius = "motion" in outcome ? outcome.posed.body.radius : undefined;
  const rounds = passage && Math.abs(passage.yawRate) / (2 * Math.PI);
  return {
    // The numbers of these two tick; see verdict.ts.
    turned: { name: "Contact ran round", number: "", note: inThisTurn(passage, motion) },
    itself: {
      name: `The ${BODY_NOUNS[setup.body]} itself`,
      number: "",
      note: "turned meanwhile",
    },
    theory: {
      name: "In theory",
      number: degrees(theory?.here ?? NaN, 2),
      note: comparison(passage && Math.abs(passage.angle), passage?.minTilt, theory, setup),
    },
    lowest: {
      name: "Smallest tilt",
      number: passage ? `${shownWide((passage.minTilt * 180) / Math.PI, 2)}°` : "–",
      note: passage && radius ? `a gap of ${gapOf(passage, radius)}` : "",
    },
    then: {
      name: "Contact point then",
      number: rounds === undefined ? "–" : shownWide(rounds, 3),
      note:
        passage && radius ? `rounds per second: ${speedOf(passage, radius)}` : "rounds per second",
    },
    said: story(passage, motion, setup),
    ended: ending(outcome, setup),
    amiss: !begun && (motion === undefined || AMISS.includes(motion.status)),
  };
}
