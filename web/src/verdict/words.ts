// What happened, in plain words.

import type { Outcome } from "../lab";
import type { Theory } from "../core/core";
import type { Motion } from "../core/motion";
import { degrees, shown, shownTime } from "../inputs/shown";
import type { Setup } from "../setup/setup";
import type { Passage } from "./passage";

/** What the body did on its way down and up. */
export function story(passage: Passage | undefined, setup: Readonly<Setup>): string {
  if (!passage) return "";
  const { angle, swiftness, rim } = passage;
  const round = `The lean swung round by ${degrees(Math.abs(angle), 1)}`;
  const swift = `, most of that in ${shownTime(swiftness)}`;
  const law = setup.law === "coulomb" ? ` ${RIM[rim]}` : "";
  return `${round}${swift}.${beside(angle)}${law}`;
}

const RIM: Record<Passage["rim"], string> = {
  rolled: "Friction held: it rolled all the way, without slipping.",
  slipped: "The rim slipped on the way.",
  jumped: "The rim jumped off the table on the way.",
};

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

/** How the theory compares with what was computed; or why it does not. */
export function comparison(
  passage: Passage | undefined,
  theory: Theory | undefined,
  setup: Readonly<Setup>,
): string {
  if (!theory || Number.isNaN(theory.here)) return "it does not come down";
  const limits = [
    ...(passage && passage.minTilt > FLAT ? ["for coming down flat"] : []),
    ...(setup.twist === 0 ? [] : ["for a body that is not twisted"]),
  ];
  const said = passage
    ? difference(theory.here, Math.abs(passage.angle))
    : "the limit on this table";
  return limits.length === 0 ? said : `${said}; it is ${limits.join(" and ")}`;
}

/** The theory is the limit of coming down flat: flatter than this, rad, it is near. */
const FLAT = Math.PI / 180;

function difference(theory: number, happened: number): string {
  // Of the numbers as they are shown, for whoever subtracts them.
  const hundredths = (angle: number) => Math.round((angle * 18_000) / Math.PI);
  const size = Math.abs(hundredths(happened) - hundredths(theory));
  if (size === 0) return "what happened here";
  return `${(size / 100).toFixed(2)}° ${happened > theory ? "below" : "above"} what happened here`;
}

/** How it ended, or why there is nothing. */
export function ending(outcome: Outcome, setup: Readonly<Setup>): string {
  if ("refused" in outcome) return `There is no motion to show: ${outcome.refused}.`;
  const { motion, theory } = outcome;
  const after = shownTime(motion.end);
  switch (motion.status) {
    case "finished":
      return `It still moves after ${shown(motion.end, 3)} s, when the computation ends.`;
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

function faceDown(after: string, { sideways, twist, rolling }: Readonly<Setup>): string {
  const unknown = "the mechanics of rigid bodies does not say";
  if (sideways === 0 && twist === 0)
    return `Face down after ${after}: without any sideways motion the whole rim meets the table at once, and what follows then ${unknown}. Any sideways error, however small, lets the contact point run round instead; from 10⁻¹² rad/s on that can be followed.`;
  if (rolling > 0)
    return `Face down after ${after}: rolling resistance stopped the contact point, and the base slaps the table flat. What follows when every point of the rim collides at once, ${unknown}; less resistance lets it run round.`;
  return `Face down after ${after}: it came down so flat that no clock could follow the contact point round the rim. A larger sideways error can be followed.`;
}

const came = (motion: Motion) => motion.events.some(({ kind }) => kind === "tilt_min");
