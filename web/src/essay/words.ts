// What the essay says of a motion, in words.

import type { Theory } from "../core/core";
import { formatDegrees } from "../format/numbers";
import { formatLengthShort } from "../format/sizes";
import { formatDuration } from "../format/times";
import type { Setup } from "../setup/setup";
import type { Passage } from "../verdict/passage";
import { say, sentences, words } from "../words/words";

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
  const { essay } = words;
  return sentences(
    say(essay.cameUp, { said: `${said}°`, straight: said === 180, turned: `${turned}°` }),
    apart <= 3
      ? essay.guessedWell
      : say(essay.guessedOff, { angle: `${apart}°`, further: turned > said }),
  );
}

/** Says how far the contact point ran and the body itself turned. */
export function ranRound({ passage, setup, gap, time }: Facts): string {
  const [angle, itself] = [passage.angle, passage.bodyAngle].map((angle) =>
    formatDegrees(Math.abs(angle), 1),
  ) as [string, string];
  return say(words.essay.ranRound, { angle, time, ...words.nouns[setup.body], itself, gap });
}

/** The guess as people read it. */
export function guessInWords(degrees: number): string {
  const aside = Math.abs(degrees - 180);
  return aside === 0
    ? say(words.essay.straight, { angle: `${degrees}°` })
    : say(words.essay.notStraight, {
        angle: `${degrees}°`,
        aside: `${aside}°`,
        beyond: degrees > 180,
      });
}
