// The limits of the model in words, with the numbers of a motion.

import { formatLengthShort, formatSpeed } from "../format/sizes";
import { formatDuration } from "../format/times";
import { formatWide } from "../format/numbers";
import type { Validity } from "../core/motion";

export interface Limit {
  name: string;
  /** What the motion shown has. */
  here: string;
  /** What that means. */
  means: string;
  /** Whether the model leaves out something that matters here. */
  exceeded: boolean;
}

export function limitsOf(validity: Validity): Limit[] {
  return [gap, speed, rigid, force, losses].map((limit) => limit(validity));
}

function gap({ gap, roughness: [smooth], exceeded: { gap: exceeded } }: Validity): Limit {
  const means = exceeded
    ? gap < smooth
      ? "Smaller than the roughness of any rim and table, 1 to 10 µm: they touch at several points."
      : "No larger than the roughness of rim and table, 1 to 10 µm: they may touch at several points."
    : "Larger than the roughness of rim and table, 1 to 10 µm.";
  return { name: "Smallest gap under the rim", here: formatLengthShort(gap), means, exceeded };
}

function speed({
  contactSpeed,
  speedOfSound,
  exceeded: { contactSpeed: exceeded },
}: Validity): Limit {
  const compared = exceeded
    ? "Faster than"
    : contactSpeed > speedOfSound / 10
      ? "Not much slower than"
      : "Slower than";
  return {
    name: "Contact point along the rim",
    here: formatSpeed(contactSpeed),
    means: `${compared} sound in steel, aluminium or glass, 5 to 6 km/s${exceeded ? ": rim and table cannot make way for it in time" : ""}.`,
    exceeded,
  };
}

function rigid({ passageTime, soundTime, exceeded: { passageTime: exceeded } }: Validity): Limit {
  const sound = `Sound needs ${formatDuration(soundTime)} to cross the base`;
  return {
    name: "Time for most of the angle",
    here: formatDuration(passageTime),
    means: exceeded
      ? `${sound}: the body bends and rings instead of moving as one piece.`
      : `${sound}: the body moves as one piece.`,
    exceeded,
  };
}

function force({ forceRatio, exceeded: { forceRatio: exceeded } }: Validity): Limit {
  return {
    name: "Largest force on the table",
    here: `${formatWide(forceRatio, 2)} × the weight`,
    means: exceeded
      ? "At one point: a real rim and table yield there, and the body rings."
      : "At one point of a rim that does not yield.",
    exceeded,
  };
}

function losses({ lossRatio, exceeded: { lossRatio: exceeded } }: Validity): Limit {
  return {
    name: "Energy lost in this turn",
    here: lossRatio < 5e-4 ? "0 %" : `${formatWide(100 * lossRatio, 2)} %`,
    means: exceeded
      ? "A real can loses a part in every turn, by sound, air and bending, and soon stands still. “Rolling resistance” is one such loss."
      : "Sound, air and bending, which are left out, take more.",
    exceeded,
  };
}
