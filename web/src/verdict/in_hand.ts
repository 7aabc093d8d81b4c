// The verdict on a held body: the fall that would follow if the hand let go now.

import type { Fall } from "../core/core";
import type { Preview } from "../falls/preview";
import { formatDegrees, formatExact, formatWide } from "../format/numbers";
import { formatDuration } from "../format/times";
import type { Setup } from "../setup/setup";
import type { Content } from "./content";
import { beside, comparison } from "./words";
import { say, sentences, words } from "../words/words";

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
