// Describes a motion in words.

import type { Outcome } from "../lab";
import type { Theory } from "../core/core";
import type { Motion } from "../core/motion";
import { formatDegrees, formatFixed, formatNumber } from "../format/numbers";
import { formatDuration } from "../format/times";
import type { Setup } from "../setup/setup";
import type { Passage } from "./passage";
import { sentences, words } from "../words/words";

/** Describes a passage: from when to when the angle is counted, how far the contact point runs, and how
 * far the body itself turns. */
export function story(
  passage: Passage | undefined,
  motion: Motion | undefined,
  setup: Readonly<Setup>,
): string {
  if (!passage) return "";
  const { start, end, complete, angle, bodyAngle, validity, rim } = passage;
  const itself = formatDegrees(Math.abs(bodyAngle), 1);
  const turned = words.verdict.story({
    start: start === 0 ? undefined : formatDuration(start),
    end: formatDuration(end),
    endsWith: complete ? "maximum" : motion?.status === "toppled" ? "fall" : "end",
    angle: formatDegrees(Math.abs(angle), 1),
    time: formatDuration(validity.passageTime),
    body: setup.body,
    itself,
    way: itself === formatDegrees(0, 1) ? "none" : bodyAngle > 0 === angle > 0 ? "same" : "other",
  });
  return sentences(turned, beside(angle), setup.law === "coulomb" ? words.verdict.rim[rim] : "");
}

/** Compares an angle of turn with the half turn of plain rocking. */
export function beside(angle: number): string {
  const size = Math.abs(angle);
  const veer = size - Math.PI;
  if (size > 2 * Math.PI) return words.verdict.fullTurn(formatDegrees(size - 2 * Math.PI, 1));
  if (Math.abs(veer) > Math.PI / 2) return "";
  return words.verdict.veers(
    formatDegrees(Math.abs(veer), 1),
    veer > 0 === angle > 0 ? "left" : "right",
  );
}

/** The angle of the complete turn that is shown, or the reason why there is none. */
export function inThisTurn(passage: Passage | undefined, motion: Motion | undefined): string {
  const { verdict } = words;
  if (passage)
    return verdict.ofAngle(
      formatDegrees(Math.abs(passage.angle), 2),
      passage.complete ? "turn" : motion?.status === "toppled" ? "fall" : "end",
    );
  if (motion?.status === "face_down") return verdict.comesDownFlat;
  return motion?.turns.length ? verdict.incomplete : verdict.staysUp;
}

/** Compares the theory with a computed turn, given its angle and smallest tilt (rad), or gives the reason
 * why that is impossible. */
export function comparison(
  turn: number | undefined,
  minTilt: number | undefined,
  theory: Theory | undefined,
  setup: Readonly<Setup>,
): string {
  if (!theory || Number.isNaN(theory.here)) return words.verdict.staysUp;
  const flat = minTilt !== undefined && minTilt > FLAT;
  const untwisted = setup.twist !== 0;
  const text = turn === undefined ? words.verdict.limitHere : difference(theory.here, turn);
  return flat || untwisted ? words.verdict.holds(text, flat, untwisted) : text;
}

/** The theory is the limit of small smallest tilts. Above this tilt, rad, it is only rough. */
const FLAT = Math.PI / 180;

function difference(theory: number, computed: number): string {
  // Subtract the rounded numbers, as a reader would.
  const hundredths = (angle: number) => Math.round((angle * 18_000) / Math.PI);
  const size = Math.abs(hundredths(computed) - hundredths(theory));
  if (size === 0) return words.verdict.asComputed;
  const angle = `${formatFixed(size / 100, 2)}°`;
  return computed > theory ? words.verdict.below(angle) : words.verdict.above(angle);
}

/** How the motion ends, or why there is none. */
export function ending(outcome: Outcome, setup: Readonly<Setup>): string {
  const { verdict } = words;
  if ("refused" in outcome) return verdict.noMotion(outcome.refused);
  const { motion, theory, partial } = outcome;
  const after = formatDuration(motion.end);
  if (partial) return verdict.stillComputing(after);
  switch (motion.status) {
    case "finished":
      return verdict.stillMoves(`${formatNumber(motion.end, 3)} s`);
    case "toppled":
      return cameDown(motion) ? verdict.fallsOver(after) : verdict.fallsBack(after);
    case "lifted_off":
      return verdict.liftsOff(motion.end === 0 ? undefined : after);
    case "face_down":
      return faceDown(after, setup);
    case "at_rest":
      return verdict.comesToRest(after);
    case "painleve":
      return verdict.painleve(after, formatNumber(theory.painleveFriction, 3));
    default:
      return motion.ranOutOfSteps
        ? verdict.tooManySteps(after)
        : verdict.cannotContinue(after, motion.message);
  }
}

/** Words of the core in a sentence on the end of a motion; they are English in every language. */
export function wordsOfCore(outcome: Outcome): string {
  if ("refused" in outcome) return isOwn(outcome.refused) ? "" : outcome.refused;
  return outcome.motion.status === "failed" ? outcome.motion.message : "";
}

/** Whether a reason is one of the page and not of the core. */
function isOwn(reason: string): boolean {
  const { floor, verdict } = words;
  const [failed = ""] = verdict.computationFailed("\n").split("\n");
  return [floor.isLoading, floor.isMissing].includes(reason) || reason.startsWith(failed);
}

function faceDown(after: string, { sideways, twist, rolling }: Readonly<Setup>): string {
  const { verdict } = words;
  if (sideways === 0 && twist === 0) return verdict.faceDownStraight(after, "10⁻¹² rad/s");
  return rolling > 0 ? verdict.faceDownResisted(after) : verdict.faceDownShort(after);
}

const cameDown = (motion: Motion) => motion.events.some(({ kind }) => kind === "tilt_min");
