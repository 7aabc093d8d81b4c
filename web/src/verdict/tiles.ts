// The content of the verdict: on a motion, and on a held body.

import {
  formatDegrees,
  formatDuration,
  formatExact,
  formatLengthShort,
  formatSpeed,
  formatWide,
} from "../format";
import type { Lab } from "../lab";
import type { Passage } from "./passage";
import type { Content } from "./content";
import { beside, comparison, ending, inThisTurn, story, wordsOfCore } from "./words";
import { say, sentences, words } from "../words/words";
import type { Fall } from "../core/core";
import type { Preview } from "../falls/flicks";
import type { Setup } from "../setup/setup";

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

// The verdict on a held body: the fall that would follow if the hand let go now.

export function contentInHand(preview: Preview, setup: Readonly<Setup>): Content {
  const { lean, theory } = preview;
  // The preview is that of a fall on a floor at rest.
  const moves = setup.floor !== "rest";
  const fall = moves ? undefined : preview.fall;
  const turn = fall && !Number.isNaN(fall.turn) ? Math.abs(fall.turn) : undefined;
  const [tilt, way] = [`${formatExact(lean.tilt)}°`, `${formatExact(lean.yaw)}°`];
  const { verdict } = words;
  const { wouldBe } = verdict;
  const result = fall ? resultOf(fall) : moves ? wouldBe.floorMoves : wouldBe.nothing;
  return {
    turned: {
      name: verdict.angleOfTurn,
      number: turn === undefined ? "–" : formatDegrees(turn, 1),
      note: verdict.ifLetGo,
    },
    itself: {
      name: say(verdict.itself, { ...words.nouns[setup.body] }),
      number: "–",
      note: verdict.whenLetGo,
    },
    theory: {
      name: verdict.theory,
      number: formatDegrees(theory?.here ?? NaN, 2),
      note: comparison(undefined, fall?.minTilt, theory, { ...setup, twist: 0 }),
    },
    lowest: {
      name: verdict.smallestTilt,
      number:
        turn === undefined ? "–" : `${formatWide(((fall?.minTilt ?? 0) * 180) / Math.PI, 2)}°`,
      note: verdict.ifLetGo,
    },
    then: { name: verdict.inHand, number: tilt, note: say(verdict.leansToward, { way }) },
    said: sentences(
      say(verdict.leansInHand, { tilt, way }),
      result,
      fall && turn !== undefined ? beside(fall.turn) : "",
    ),
    ended: verdict.toFlick,
    english: "",
    abnormal: false,
  };
}

/** The fall and its outcome in a sentence. */
function resultOf({ outcome, turn, time }: Readonly<Fall>): string {
  const after = formatDuration(time);
  const angle = formatDegrees(Math.abs(turn), 1);
  const { wouldBe } = words.verdict;
  switch (outcome) {
    case "rocked":
    case "toppled":
      return say(wouldBe[outcome], { angle, after });
    case "hovered":
    case "fell_back":
    case "face_down":
    case "at_rest":
    case "lifted_off":
    case "painleve":
      return say(wouldBe[outcome], { after });
    default:
      return wouldBe.failed;
  }
}

// The gap and the speed of the near-collision for a body of this size.

/** Height of the highest point of a rim (radius in m) above the table at the smallest tilt. */
export const gapOf = ({ minTilt }: Passage, radius: number): string =>
  formatLengthShort(2 * radius * Math.sin(minTilt));

/** Speed of the contact point along a rim (radius in m) at the smallest tilt. */
export const speedOf = ({ yawRate }: Passage, radius: number): string =>
  formatSpeed(radius * Math.abs(yawRate));
