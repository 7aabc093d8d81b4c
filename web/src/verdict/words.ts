// Describes a motion in words.

import type { Outcome } from "../lab";
import type { Theory } from "../core/core";
import type { Motion } from "../core/motion";
import { formatDegrees, formatNumber } from "../format/numbers";
import { formatDuration } from "../format/times";
import { BODY_NOUNS } from "../setup/fields";
import type { Setup } from "../setup/setup";
import type { Passage } from "./passage";

/** Describes a passage: from when to when the angle is counted, how far the contact point runs, and how
 * far the body itself turns. */
export function story(
  passage: Passage | undefined,
  motion: Motion | undefined,
  setup: Readonly<Setup>,
): string {
  if (!passage) return "";
  const { angle, bodyAngle, validity, rim } = passage;
  const round = `the contact point runs round by ${formatDegrees(Math.abs(angle), 1)}`;
  const swift = `, most of it in ${formatDuration(validity.passageTime)}`;
  const itself = `the ${BODY_NOUNS[setup.body]} itself turns ${bodyTurn(bodyAngle, angle)}`;
  const law = setup.law === "coulomb" ? ` ${RIM[rim]}` : "";
  return `${interval(passage, motion)} ${round}${swift}; ${itself}.${beside(angle)}${law}`;
}

/** Rotation of the body itself, and whether it has the direction of the contact point. */
function bodyTurn(bodyAngle: number, angle: number): string {
  const size = formatDegrees(Math.abs(bodyAngle), 1);
  if (size === formatDegrees(0, 1)) return size;
  return `${size} ${bodyAngle > 0 === angle > 0 ? "the same way" : "the other way"}`;
}

/** The two moments between which the angle is counted. */
function interval({ start, end, complete }: Passage, motion: Motion | undefined): string {
  const from = start === 0 ? "the release" : `the tilt maximum at ${formatDuration(start)}`;
  const fell = motion?.status === "toppled" ? "its fall" : "the end";
  return `From ${from}, down and up to ${complete ? "the next tilt maximum" : fell} at ${formatDuration(end)},`;
}

const RIM: Record<Passage["rim"], string> = {
  rolled: "Friction suffices: it rolls all the way.",
  slipped: "The rim slips on the way.",
  jumped: "The rim jumps off the table on the way.",
};

/** Compares an angle of turn with the half turn of plain rocking. */
export function beside(angle: number): string {
  const size = Math.abs(angle);
  const veer = size - Math.PI;
  if (size > 2 * Math.PI)
    return ` That is one full turn and ${formatDegrees(size - 2 * Math.PI, 1)}.`;
  if (Math.abs(veer) > Math.PI / 2) return "";
  const left = veer > 0 === angle > 0;
  return ` It veers ${formatDegrees(Math.abs(veer), 1)} to the ${left ? "left" : "right"} of straight across.`;
}

/** The angle of the complete turn that is shown, or the reason why there is none. */
export function inThisTurn(passage: Passage | undefined, motion: Motion | undefined): string {
  if (passage)
    return `of ${formatDegrees(Math.abs(passage.angle), 2)} ${passage.complete ? "in this turn" : until(motion)}`;
  if (motion?.status === "face_down") return "it comes down flat";
  return motion?.turns.length ? "the next turn is not complete" : "it does not come down";
}

const until = (motion: Motion | undefined) =>
  motion?.status === "toppled" ? "when it falls" : "at the end";

/** Compares the theory with a computed turn, given its angle and smallest tilt (rad), or gives the reason
 * why that is impossible. */
export function comparison(
  turn: number | undefined,
  minTilt: number | undefined,
  theory: Theory | undefined,
  setup: Readonly<Setup>,
): string {
  if (!theory || Number.isNaN(theory.here)) return "it does not come down";
  const limits = [
    ...(minTilt !== undefined && minTilt > FLAT ? ["comes down flat"] : []),
    ...(setup.twist === 0 ? [] : ["is not twisted"]),
  ];
  const text = turn === undefined ? "the limit on this table" : difference(theory.here, turn);
  return limits.length === 0 ? text : `${text}; it holds for a body that ${limits.join(" and ")}`;
}

/** The theory is the limit of small smallest tilts. Above this tilt, rad, it is only rough. */
const FLAT = Math.PI / 180;

function difference(theory: number, computed: number): string {
  // Subtract the rounded numbers, as a reader would.
  const hundredths = (angle: number) => Math.round((angle * 18_000) / Math.PI);
  const size = Math.abs(hundredths(computed) - hundredths(theory));
  if (size === 0) return "as computed here";
  return `${(size / 100).toFixed(2)}° ${computed > theory ? "below" : "above"} the computed turn`;
}

/** How the motion ends, or why there is none. */
export function ending(outcome: Outcome, setup: Readonly<Setup>): string {
  if ("refused" in outcome) return `There is no motion to show: ${outcome.refused}.`;
  const { motion, theory, partial } = outcome;
  const after = formatDuration(motion.end);
  if (partial) return `The motion after ${after} is still being computed.`;
  switch (motion.status) {
    case "finished":
      return `It still moves after ${formatNumber(motion.end, 3)} s, when the computation ends.`;
    case "toppled":
      return cameDown(motion)
        ? `It falls over after ${after}.`
        : `It falls over after ${after}, the way it leans at first.`;
    case "lifted_off":
      return `${motion.end === 0 ? "At once" : `After ${after}`} the rim would leave the table. The ideal laws do not cover flight, so the motion ends here. Choose dry friction to follow it.`;
    case "face_down":
      return faceDown(after, setup);
    case "at_rest":
      return `It comes to rest after ${after}: its base lies flat and its energy is spent.`;
    case "painleve":
      return `Painlevé’s paradox after ${after}: with so much friction, rigid-body mechanics has no unique answer for the sliding rim. For this body, lying nearly flat, the paradox begins at a friction of ${formatNumber(theory.painleveFriction, 3)}. Set less friction to follow the motion.`;
    default:
      return motion.ranOutOfSteps
        ? `The computation stops after ${after}, because it needs too many steps. Set a shorter duration.`
        : `The computation cannot continue after ${after}: ${motion.message}.`;
  }
}

function faceDown(after: string, { sideways, twist, rolling }: Readonly<Setup>): string {
  const unknown = "Rigid-body mechanics does not determine what follows";
  if (sideways === 0 && twist === 0)
    return `Face down after ${after}: without any sideways motion the whole rim meets the table at once. ${unknown}. With any sideways error, however small, the contact point runs round instead; an error of 10⁻¹² rad/s or more can be computed.`;
  if (rolling > 0)
    return `Face down after ${after}: rolling resistance stops the contact point, and the base slaps the table flat. ${unknown} when every point of the rim collides at once. With less resistance the contact point runs round.`;
  return `Face down after ${after}: it comes down so flat that the run of the contact point round the rim is too short to be computed. Set a larger sideways error.`;
}

const cameDown = (motion: Motion) => motion.events.some(({ kind }) => kind === "tilt_min");
