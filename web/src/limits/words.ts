// The limits of the model in words, with the numbers of a motion.

import { formatLengthShort, formatSpeed } from "../format/sizes";
import { formatDuration } from "../format/times";
import { formatWide } from "../format/numbers";
import { type Numbers, ROUGHNESS, SOUND } from "./numbers";

export interface Limit {
  name: string;
  /** What the motion shown has. */
  here: string;
  /** What that means. */
  means: string;
  /** Whether the model leaves out something that matters here. */
  exceeded: boolean;
}

export function limitsOf(numbers: Numbers): Limit[] {
  return [gap(numbers), speed(numbers), rigid(numbers), force(numbers), losses(numbers)];
}

function gap({ gap }: Numbers): Limit {
  const [fine, coarse] = ROUGHNESS;
  const exceeded = gap < coarse;
  const means = exceeded
    ? gap < fine
      ? "Smaller than the roughness of any rim and table, 1 to 10 µm: they touch at several points."
      : "No larger than the roughness of rim and table, 1 to 10 µm: they may touch at several points."
    : "Larger than the roughness of rim and table, 1 to 10 µm.";
  return { name: "Smallest gap under the rim", here: formatLengthShort(gap), means, exceeded };
}

function speed({ speed }: Numbers): Limit {
  const exceeded = speed > SOUND;
  const compared = exceeded
    ? "Faster than"
    : speed > SOUND / 10
      ? "Not much slower than"
      : "Slower than";
  return {
    name: "Contact point along the rim",
    here: formatSpeed(speed),
    means: `${compared} sound in steel, aluminium or glass, 5 to 6 km/s${exceeded ? ": rim and table cannot make way for it in time" : ""}.`,
    exceeded,
  };
}

function rigid({ passage, crossing }: Numbers): Limit {
  const exceeded = passage < 10 * crossing;
  const sound = `Sound needs ${formatDuration(crossing)} to cross the base`;
  return {
    name: "Time for most of the angle",
    here: formatDuration(passage),
    means: exceeded
      ? `${sound}: the body bends and rings instead of moving as one piece.`
      : `${sound}: the body moves as one piece.`,
    exceeded,
  };
}

function force({ force }: Numbers): Limit {
  const exceeded = force > 100;
  return {
    name: "Largest force on the table",
    here: `${formatWide(force, 2)} × the weight`,
    means: exceeded
      ? "At one point: a real rim and table yield there, and the body rings."
      : "At one point of a rim that does not yield.",
    exceeded,
  };
}

function losses({ loss }: Numbers): Limit {
  const exceeded = loss < 0.01;
  return {
    name: "Energy lost in this turn",
    here: loss < 5e-4 ? "0 %" : `${formatWide(100 * loss, 2)} %`,
    means: exceeded
      ? "A real can loses a part in every turn, by sound, air and bending, and soon stands still. “Rolling resistance” is one such loss."
      : "Sound, air and bending, which are left out, take more.",
    exceeded,
  };
}
