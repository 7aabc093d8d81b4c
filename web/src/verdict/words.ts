// What happened, in plain words.

import type { Outcome } from "../lab";
import type { Theory } from "../core/core";
import type { Motion } from "../core/motion";
import { degrees, shown, shownTime } from "../inputs/shown";
import type { Setup } from "../setup/setup";
import type { Passage } from "./passage";

/** What the contact point did. */
export function story(passage: Passage | undefined, setup: Readonly<Setup>): string {
  if (!passage) return "";
  const { angle, swiftness, slipped } = passage;
  const round = `The contact point ran round the rim by ${degrees(Math.abs(angle), 1)}`;
  const swift = `, most of that in ${shownTime(swiftness)}`;
  const law =
    setup.law !== "coulomb"
      ? ""
      : slipped
        ? " The rim slipped on the way."
        : " Friction held: it rolled, without slipping.";
  return `${round}${swift}.${beside(angle)}${law}`;
}

/** An angle of turn beside the half turn that a plain rocking would be. */
function beside(angle: number): string {
  const size = Math.abs(angle);
  const veer = size - Math.PI;
  if (size > 2 * Math.PI)
    return ` That is ${degrees(size - 2 * Math.PI, 1)} more than once around.`;
  if (Math.abs(veer) > Math.PI / 2) return "";
  const left = veer > 0 === angle > 0;
  return ` It veers ${degrees(Math.abs(veer), 1)} to the ${left ? "left" : "right"} of straight across.`;
}

/** How far round in all; or why there is no telling. */
export function inAll(passage: Passage | undefined, motion: Motion | undefined): string {
  if (passage)
    return `${degrees(Math.abs(passage.angle), 2)} ${passage.whole ? "in all" : ended(motion)}`;
  if (motion?.status === "face_down") return "it comes down flat";
  return motion?.turns.length ? "the next is not complete" : "it does not come down";
}

const ended = (motion: Motion | undefined) =>
  motion?.status === "toppled" ? "where it fell" : "at the end";

/** How what was computed compares with the theory; or why it does not. */
export function comparison(passage: Passage | undefined, theory: Theory | undefined): string {
  if (!theory || Number.isNaN(theory.here)) return "it does not come down";
  if (!passage) return "the limit on this table";
  const off = Math.abs(passage.angle) - theory.here;
  const difference = `${degrees(Math.abs(off), 2)} ${off >= 0 ? "less" : "more"}`;
  // The theory is the limit of coming down flat.
  const FLAT = Math.PI / 180;
  return passage.minTilt > FLAT ? `${difference}; it is for coming down flat` : difference;
}

/** How it ended, or why there is nothing. */
export function ending(outcome: Outcome, setup: Readonly<Setup>): string {
  if ("refused" in outcome) return `There is no motion to show: ${outcome.refused}.`;
  const { motion, theory } = outcome;
  const after = shownTime(motion.end);
  switch (motion.status) {
    case "finished":
      return `After ${shown(motion.end, 3)} s it still moves; it was followed no longer.`;
    case "toppled":
      return came(motion)
        ? `It fell over after ${after}.`
        : `It fell over after ${after}, the way it leaned at first.`;
    case "lifted_off":
      return `${motion.end === 0 ? "At once" : `After ${after}`} the rim would jump off the table. The ideal laws know no jumping, so this is where the motion ends; with dry friction it can be followed.`;
    case "face_down":
      return faceDown(after, setup);
    case "at_rest":
      return `It came to rest after ${after}: its base lies flat and its energy is spent.`;
    case "painleve":
      return `Painlevé’s paradox, after ${after}: the sliding rim would be pressed down by its own friction, and the mechanics of rigid bodies has no one answer. For this body lying nearly flat that begins at a friction of ${shown(theory.painleveFriction, 3)}; set less to follow it.`;
    default:
      return /max_steps/.test(motion.message)
        ? `The computation was stopped after ${after}, as it took too many steps. Follow it for a shorter time.`
        : `The computation could not go on after ${after}: ${motion.message}.`;
  }
}

function faceDown(after: string, setup: Readonly<Setup>): string {
  if (setup.rolling > 0)
    return `Face down after ${after}: rolling resistance stopped the contact point, and the base slaps the table flat. What follows when every point of the rim collides at once, the mechanics of rigid bodies does not say; less resistance lets it run round.`;
  return `Face down after ${after}: without any sideways motion the whole rim meets the table at once, and what follows then the mechanics of rigid bodies does not say. The least sideways error, 0.000001 rad/s, is enough for the contact point to run round instead.`;
}

const came = (motion: Motion) => motion.events.some(({ kind }) => kind === "tilt_min");
