// The verdict on a held body: the fall that would follow if the hand let go now.

import type { Fall } from "../core/core";
import type { Preview } from "../falls/preview";
import { formatDegrees, formatExact, formatWide } from "../format/numbers";
import { formatDuration } from "../format/times";
import { BODY_NOUNS } from "../setup/fields";
import type { Setup } from "../setup/setup";
import type { Content } from "./content";
import { beside, comparison } from "./words";

export function contentInHand(preview: Preview, setup: Readonly<Setup>): Content {
  const { lean, theory } = preview;
  // The preview is that of a fall on a floor at rest.
  const moves = setup.floor !== "rest";
  const fall = moves ? undefined : preview.fall;
  const turn = fall && !Number.isNaN(fall.turn) ? Math.abs(fall.turn) : undefined;
  const [tilt, way] = [`${formatExact(lean.tilt)}°`, `${formatExact(lean.yaw)}°`];
  const result = fall
    ? resultOf(fall)
    : moves
      ? "the floor begins to move"
      : "there would be no motion";
  return {
    turned: {
      name: "Angle of turn",
      number: turn === undefined ? "–" : formatDegrees(turn, 1),
      note: "if you let go now",
    },
    itself: {
      name: `The ${BODY_NOUNS[setup.body]} itself`,
      number: "–",
      note: "seen when you let go",
    },
    theory: {
      name: "In theory",
      number: formatDegrees(theory?.here ?? NaN, 2),
      note: comparison(undefined, fall?.minTilt, theory, { ...setup, twist: 0 }),
    },
    lowest: {
      name: "Smallest tilt",
      number:
        turn === undefined ? "–" : `${formatWide(((fall?.minTilt ?? 0) * 180) / Math.PI, 2)}°`,
      note: "if you let go now",
    },
    then: { name: "In your hand", number: tilt, note: `leans toward ${way}` },
    said: `In your hand it leans by ${tilt} toward ${way}. If you let go at rest now, ${result}.${fall && turn !== undefined ? beside(fall.turn) : ""}`,
    ended: "To flick it, let go while your hand moves.",
    abnormal: false,
  };
}

/** The fall and its outcome, as the end of a sentence. */
function resultOf({ outcome, turn, time }: Readonly<Fall>): string {
  const after = `after ${formatDuration(time)}`;
  const round = `its contact point would run round by ${formatDegrees(Math.abs(turn), 1)}`;
  switch (outcome) {
    case "rocked":
      return `${round} on its way down and up to the next tilt maximum, ${after}`;
    case "hovered":
      return `it would not have come down and up again ${after}, when the computation ends`;
    case "toppled":
      return `${round}, and it would fall over ${after}`;
    case "fell_back":
      return `it would fall over the way it leans, ${after}`;
    case "face_down":
      return `it would come down flat, ${after}`;
    case "at_rest":
      return `it would come to rest on its base ${after}`;
    case "lifted_off":
      return `its rim would leave the table ${after}, where the ideal laws end`;
    case "painleve":
      return `it would meet Painlevé’s paradox ${after}, where rigid-body mechanics has no unique answer`;
    default:
      return "the computation would fail";
  }
}
