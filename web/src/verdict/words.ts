// Describes a motion in words.

import type { Outcome } from "../lab";
import type { Theory } from "../core/core";
import type { Motion } from "../core/motion";
import { formatDegrees, formatDuration, formatFixed, formatNumber } from "../format";
import type { Setup } from "../setup/setup";
import type { Passage } from "./passage";
import { say, sentences, words } from "../words/words";

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
  const turned = say(words.verdict.story, {
    begins: start === 0 ? "release" : "maximum",
    start: formatDuration(start),
    end: formatDuration(end),
    endsWith: complete ? "maximum" : motion?.status === "toppled" ? "fall" : "end",
    angle: formatDegrees(Math.abs(angle), 1),
    time: formatDuration(validity.passageTime),
    ...words.nouns[setup.body],
    itself,
    way: itself === formatDegrees(0, 1) ? "none" : bodyAngle > 0 === angle > 0 ? "same" : "other",
  });
  return sentences(turned, beside(angle), setup.law === "coulomb" ? words.verdict.rim[rim] : "");
}

/** Compares an angle of turn with the half turn of plain rocking. */
export function beside(angle: number): string {
  const size = Math.abs(angle);
  const veer = size - Math.PI;
  if (size > 2 * Math.PI)
    return say(words.verdict.fullTurn, { rest: formatDegrees(size - 2 * Math.PI, 1) });
  if (Math.abs(veer) > Math.PI / 2) return "";
  return say(words.verdict.veers, {
    angle: formatDegrees(Math.abs(veer), 1),
    side: veer > 0 === angle > 0 ? "left" : "right",
  });
}

/** The angle of the complete turn that is shown, or the reason why there is none. */
export function inThisTurn(passage: Passage | undefined, motion: Motion | undefined): string {
  const { verdict } = words;
  if (passage)
    return say(verdict.ofAngle, {
      angle: formatDegrees(Math.abs(passage.angle), 2),
      until: passage.complete ? "turn" : motion?.status === "toppled" ? "fall" : "end",
    });
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
  if (!flat && !untwisted) return text;
  const condition = flat && untwisted ? "both" : flat ? "flat" : "untwisted";
  return say(words.verdict.holds, { text, condition });
}

/** The theory is the limit of small smallest tilts. Above this tilt, rad, it is only rough. */
const FLAT = Math.PI / 180;

function difference(theory: number, computed: number): string {
  // Subtract the rounded numbers, as a reader would.
  const hundredths = (angle: number) => Math.round((angle * 18_000) / Math.PI);
  const size = Math.abs(hundredths(computed) - hundredths(theory));
  if (size === 0) return words.verdict.asComputed;
  const angle = `${formatFixed(size / 100, 2)}°`;
  return computed > theory
    ? say(words.verdict.below, { angle })
    : say(words.verdict.above, { angle });
}

/** How the motion ends, or why there is none. */
export function ending(outcome: Outcome, setup: Readonly<Setup>): string {
  const { verdict } = words;
  if ("refused" in outcome) return say(verdict.noMotion, { why: outcome.refused });
  const { motion, theory, partial } = outcome;
  const after = formatDuration(motion.end);
  if (partial) return say(verdict.stillComputing, { after });
  switch (motion.status) {
    case "finished":
      return say(verdict.stillMoves, { after: `${formatNumber(motion.end, 3)} s` });
    case "toppled":
      return cameDown(motion)
        ? say(verdict.fallsOver, { after })
        : say(verdict.fallsBack, { after });
    case "lifted_off":
      return say(verdict.liftsOff, { moment: motion.end === 0 ? "start" : "later", after });
    case "face_down":
      return faceDown(after, setup);
    case "at_rest":
      return say(verdict.comesToRest, { after });
    case "painleve":
      return say(verdict.painleve, { after, friction: formatNumber(theory.painleveFriction, 3) });
    default:
      return motion.ranOutOfSteps
        ? say(verdict.tooManySteps, { after })
        : say(verdict.cannotContinue, { after, why: motion.message });
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
  const [failed = ""] = say(verdict.computationFailed, { why: "\n" }).split("\n");
  return [floor.isLoading, floor.isMissing].includes(reason) || reason.startsWith(failed);
}

function faceDown(after: string, { sideways, twist, rolling }: Readonly<Setup>): string {
  const { verdict } = words;
  if (sideways === 0 && twist === 0)
    return say(verdict.faceDownStraight, { after, least: "10⁻¹² rad/s" });
  return rolling > 0
    ? say(verdict.faceDownResisted, { after })
    : say(verdict.faceDownShort, { after });
}

const cameDown = (motion: Motion) => motion.events.some(({ kind }) => kind === "tilt_min");
