// What happens, in plain words.

import type { Outcome } from "../lab";
import type { Theory } from "../core/core";
import type { Motion } from "../core/motion";
import { formatDegrees, formatNumber } from "../format/numbers";
import { formatDuration } from "../format/times";
import { BODY_NOUNS } from "../setup/fields";
import type { Setup } from "../setup/setup";
import type { Passage } from "./passage";

/** What happens on the way down and up: from where to where the angle is counted, how far the contact
 * point goes, and how far the body itself turns. */
export function story(
  passage: Passage | undefined,
  motion: Motion | undefined,
  setup: Readonly<Setup>,
): string {
  if (!passage) return "";
  const { angle, own, fastTime, rim } = passage;
  const round = `the contact point runs round by ${formatDegrees(Math.abs(angle), 1)}`;
  const swift = `, most of it in ${formatDuration(fastTime)}`;
  const itself = `the ${BODY_NOUNS[setup.body]} itself turns ${ownWay(own, angle)}`;
  const law = setup.law === "coulomb" ? ` ${RIM[rim]}` : "";
  return `${counted(passage, motion)} ${round}${swift}; ${itself}.${beside(angle)}${law}`;
}

/** How far the body itself turned, and which way beside the contact point. */
function ownWay(own: number, angle: number): string {
  const size = formatDegrees(Math.abs(own), 1);
  if (size === formatDegrees(0, 1)) return size;
  return `${size} ${own > 0 === angle > 0 ? "the same way" : "the other way"}`;
}

/** Between which moments the angle is counted. */
function counted({ start, end, whole }: Passage, motion: Motion | undefined): string {
  const from = start === 0 ? "the release" : `the largest tilt at ${formatDuration(start)}`;
  const fell = motion?.status === "toppled" ? "its fall" : "the end";
  return `From ${from}, down and up to ${whole ? "the next largest tilt" : fell} at ${formatDuration(end)},`;
}

const RIM: Record<Passage["rim"], string> = {
  rolled: "Friction holds: it rolls all the way.",
  slipped: "The rim slips on the way.",
  jumped: "The rim jumps off the table on the way.",
};

/** An angle of turn beside the half turn that a plain rocking would be. */
export function beside(angle: number): string {
  const size = Math.abs(angle);
  const veer = size - Math.PI;
  if (size > 2 * Math.PI)
    return ` That is ${formatDegrees(size - 2 * Math.PI, 1)} more than once around.`;
  if (Math.abs(veer) > Math.PI / 2) return "";
  const left = veer > 0 === angle > 0;
  return ` It veers ${formatDegrees(Math.abs(veer), 1)} to the ${left ? "left" : "right"} of straight across.`;
}

/** How far round in the whole of the turn that is shown; or why there is no telling. */
export function inThisTurn(passage: Passage | undefined, motion: Motion | undefined): string {
  if (passage)
    return `of ${formatDegrees(Math.abs(passage.angle), 2)} ${passage.whole ? "in this turn" : until(motion)}`;
  if (motion?.status === "face_down") return "it comes down flat";
  return motion?.turns.length ? "the next is not complete" : "it does not come down";
}

const until = (motion: Motion | undefined) =>
  motion?.status === "toppled" ? "when it falls" : "at the end";

/** How the theory compares with the angle and the smallest tilt of a turn (rad), as computed; or why
 * it does not. */
export function comparison(
  turn: number | undefined,
  minTilt: number | undefined,
  theory: Theory | undefined,
  setup: Readonly<Setup>,
): string {
  if (!theory || Number.isNaN(theory.here)) return "it does not come down";
  const limits = [
    ...(minTilt !== undefined && minTilt > FLAT ? ["for coming down flat"] : []),
    ...(setup.twist === 0 ? [] : ["for a body that is not twisted"]),
  ];
  const said = turn === undefined ? "the limit on this table" : difference(theory.here, turn);
  return limits.length === 0 ? said : `${said}; it is ${limits.join(" and ")}`;
}

/** The theory is the limit of coming down flat: flatter than this, rad, it is near. */
const FLAT = Math.PI / 180;

function difference(theory: number, happens: number): string {
  // Of the numbers as they are shown, for whoever subtracts them.
  const hundredths = (angle: number) => Math.round((angle * 18_000) / Math.PI);
  const size = Math.abs(hundredths(happens) - hundredths(theory));
  if (size === 0) return "what happens here";
  return `${(size / 100).toFixed(2)}° ${happens > theory ? "below" : "above"} what happens here`;
}

/** How it ends, or why there is nothing. */
export function ending(outcome: Outcome, setup: Readonly<Setup>): string {
  if ("refused" in outcome) return `There is no motion to show: ${outcome.refused}.`;
  const { motion, theory, partial } = outcome;
  const after = formatDuration(motion.end);
  if (partial) return `What comes after ${after} is being computed.`;
  switch (motion.status) {
    case "finished":
      return `It still moves after ${formatNumber(motion.end, 3)} s, when the computation ends.`;
    case "toppled":
      return came(motion)
        ? `It falls over after ${after}.`
        : `It falls over after ${after}, the way it leans at first.`;
    case "lifted_off":
      return `${motion.end === 0 ? "At once" : `After ${after}`} the rim would jump off the table. The ideal laws know no jumping, so this is where the motion ends; with dry friction it can be followed.`;
    case "face_down":
      return faceDown(after, setup);
    case "at_rest":
      return `It comes to rest after ${after}: its base lies flat and its energy is spent.`;
    case "painleve":
      return `Painlevé’s paradox, after ${after}: the sliding rim would be pressed down by its own friction, and the mechanics of rigid bodies has no one answer. For this body lying nearly flat that begins at a friction of ${formatNumber(theory.painleveFriction, 3)}; set less to follow it.`;
    default:
      return motion.ranOutOfSteps
        ? `The computation stops after ${after}, as it takes too many steps. Follow it for a shorter time.`
        : `The computation cannot go on after ${after}: ${motion.message}.`;
  }
}

function faceDown(after: string, { sideways, twist, rolling }: Readonly<Setup>): string {
  const unknown = "the mechanics of rigid bodies does not say";
  if (sideways === 0 && twist === 0)
    return `Face down after ${after}: without any sideways motion the whole rim meets the table at once, and what follows then ${unknown}. Any sideways error, however small, lets the contact point run round instead; from 10⁻¹² rad/s on that can be followed.`;
  if (rolling > 0)
    return `Face down after ${after}: rolling resistance stops the contact point, and the base slaps the table flat. What follows when every point of the rim collides at once, ${unknown}; less resistance lets it run round.`;
  return `Face down after ${after}: it comes down so flat that no clock can follow the contact point round the rim. A larger sideways error can be followed.`;
}

const came = (motion: Motion) => motion.events.some(({ kind }) => kind === "tilt_min");
