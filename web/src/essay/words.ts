// What the essay says of a motion, in words.

import type { Theory } from "../core/core";
import { formatDegrees } from "../format/numbers";
import { formatLengthShort } from "../format/sizes";
import { formatDuration } from "../format/times";
import { BODY_NOUNS } from "../setup/fields";
import type { Setup } from "../setup/setup";
import type { Passage } from "../verdict/passage";

export interface Facts {
  passage: Passage;
  theory: Theory;
  setup: Readonly<Setup>;
  /** Smallest gap under the highest point of the rim, in words. */
  gap: string;
  /** Time for most of the angle, in words. */
  time: string;
  /** The visitor's guess, rad. */
  guess: number;
}

export function factsOf(
  passage: Passage,
  theory: Theory,
  setup: Readonly<Setup>,
  guess: number,
): Facts {
  return {
    passage,
    theory,
    setup,
    gap: formatLengthShort(passage.validity.gap),
    time: formatDuration(passage.validity.passageTime),
    guess,
  };
}

/** Compares a guess with where the body came up, in whole degrees. */
export function cameUp({ passage, guess }: Facts): string {
  const degrees = (angle: number) => Math.round((angle * 180) / Math.PI);
  const [said, turned] = [degrees(guess), degrees(Math.abs(passage.angle))];
  const apart = Math.abs(turned - said);
  const verdict =
    apart <= 3
      ? "Well guessed!"
      : `That is ${apart}° ${turned > said ? "further round" : "less far round"} than your guess.`;
  return `You said ${said}°${said === 180 ? ", straight across" : ""}. It came up at ${turned}°. ${verdict}`;
}

/** Says how far the contact point ran and the body itself turned. */
export function ranRound({ passage, setup, gap, time }: Facts): string {
  const body = BODY_NOUNS[setup.body];
  const itself = formatDegrees(Math.abs(passage.bodyAngle), 1);
  return `The contact point ran round ${formatDegrees(Math.abs(passage.angle), 1)}, most of it in ${time}. The ${body} itself turned ${itself}. The gap under its rim fell to ${gap}, but some point of the rim always touched.`;
}

/** The guess as people read it. */
export function guessInWords(degrees: number): string {
  if (degrees === 180) return "180°, straight across";
  const aside = Math.abs(degrees - 180);
  return `${degrees}°, ${aside}° ${degrees > 180 ? "beyond" : "short of"} straight across`;
}
