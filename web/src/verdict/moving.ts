// What is said of a motion: the whole of the turn that is shown, in the present tense, as it is true
// at any time in it.

import { degrees, shownWide } from "../inputs/shown";
import type { Lab } from "../lab";
import type { Passage } from "./passage";
import type { Told } from "./told";
import { comparison, ending, inThisTurn, story } from "./words";

/** Endings that want explaining. */
const AMISS: readonly string[] = ["face_down", "painleve", "failed", "lifted_off"];

export function ofMotion(lab: Lab, passage: Passage | undefined): Told {
  const [setup, motion, theory] = [lab.setup.value, lab.motion.value, lab.theory.value];
  const rounds = passage && Math.abs(passage.yawRate) / (2 * Math.PI);
  return {
    // The number ticks; see verdict.ts.
    turned: { name: "Turned so far", number: "", note: inThisTurn(passage, motion) },
    theory: {
      name: "In theory",
      number: degrees(theory?.here ?? NaN, 2),
      note: comparison(passage && Math.abs(passage.angle), passage?.minTilt, theory, setup),
    },
    lowest: {
      name: "Flattest",
      number: passage ? `${shownWide((passage.minTilt * 180) / Math.PI, 2)}°` : "–",
      note: "smallest tilt",
    },
    then: {
      name: "Contact point",
      number: rounds === undefined ? "–" : shownWide(rounds, 3),
      note: "rounds a second, when flattest",
    },
    said: story(passage, motion, setup),
    ended: ending(lab.outcome.value, setup),
    amiss: motion === undefined || AMISS.includes(motion.status),
  };
}
