// The verdict on a motion. It describes the complete turn that is shown, in the present tense, so that
// it is true at any time of the turn.

import { formatDegrees, formatWide } from "../format/numbers";
import type { Lab } from "../lab";
import type { Passage } from "./passage";
import { gapOf, speedOf } from "./size";
import type { Content } from "./content";
import { comparison, ending, inThisTurn, story, wordsOfCore } from "./words";
import { say, words } from "../words/words";

/** Endings that need an explanation. */
const ABNORMAL: readonly string[] = ["face_down", "painleve", "failed", "lifted_off"];

/** Stands for a refused set-up. */
const NONE = { motion: undefined, theory: undefined, partial: false };

export function contentInMotion(lab: Lab, passage: Passage | undefined): Content {
  const content = contentAtRest(lab, passage);
  const { motion, shaking, theory, setup } = lab;
  if (!shaking.value || !motion.value) return content;
  const { turned } = content;
  return {
    ...content,
    turned: passage ? turned : { ...turned, note: "" },
    ...shaking.value.verdict(motion.value, theory.value?.balanceTilt ?? NaN, setup.value),
  };
}

function contentAtRest(lab: Lab, passage: Passage | undefined): Content {
  const [setup, outcome] = [lab.setup.value, lab.outcome.value];
  const { motion, theory, partial } = "motion" in outcome ? outcome : NONE;
  const radius = "motion" in outcome ? outcome.input.body.radius : undefined;
  const rounds = passage && Math.abs(passage.yawRate) / (2 * Math.PI);
  return {
    // The numbers of these two tiles change with every frame; see verdict.ts.
    turned: { name: words.verdict.turned, number: "", note: inThisTurn(passage, motion) },
    itself: {
      name: say(words.verdict.itself, { ...words.nouns[setup.body] }),
      number: "",
      note: words.verdict.meanwhile,
    },
    theory: {
      name: words.verdict.theory,
      number: formatDegrees(theory?.here ?? NaN, 2),
      note: comparison(passage && Math.abs(passage.angle), passage?.minTilt, theory, setup),
    },
    lowest: {
      name: words.verdict.smallestTilt,
      number: passage ? `${formatWide((passage.minTilt * 180) / Math.PI, 2)}°` : "–",
      note: passage && radius ? say(words.verdict.gap, { gap: gapOf(passage, radius) }) : "",
    },
    then: {
      name: words.verdict.contactThen,
      number: rounds === undefined ? "–" : formatWide(rounds, 3),
      note:
        passage && radius
          ? say(words.verdict.perSecondAt, { speed: speedOf(passage, radius) })
          : words.verdict.perSecond,
    },
    said: story(passage, motion, setup),
    ended: ending(outcome, setup),
    english: wordsOfCore(outcome),
    abnormal: !partial && (motion === undefined || ABNORMAL.includes(motion.status)),
  };
}
