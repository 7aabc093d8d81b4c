// The limits of the model in words, with the numbers of a motion.

import { formatLengthShort, formatSpeed } from "../format/sizes";
import { formatDuration } from "../format/times";
import { formatWide } from "../format/numbers";
import type { Validity } from "../core/motion";
import { say, words } from "../words/words";

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

function gap({ gap, unevenness: [fine], exceeded: { gap: exceeded } }: Validity): Limit {
  const { limits } = words;
  const means = exceeded ? (gap < fine ? limits.gapTiny : limits.gapSmall) : limits.gapWide;
  return { name: limits.gap, here: formatLengthShort(gap), means, exceeded };
}

function speed({
  contactSpeed,
  speedOfSound,
  exceeded: { contactSpeed: exceeded },
}: Validity): Limit {
  const { limits } = words;
  const isNear = contactSpeed > speedOfSound / 10;
  return {
    name: limits.speed,
    here: formatSpeed(contactSpeed),
    means: exceeded ? limits.speedBeyond : isNear ? limits.speedNear : limits.speedBelow,
    exceeded,
  };
}

function rigid({ passageTime, soundTime, exceeded: { passageTime: exceeded } }: Validity): Limit {
  const { limits } = words;
  const sound = formatDuration(soundTime);
  return {
    name: limits.time,
    here: formatDuration(passageTime),
    means: exceeded ? say(limits.bends, { sound }) : say(limits.isRigid, { sound }),
    exceeded,
  };
}

function force({ forceRatio }: Validity): Limit {
  const { limits } = words;
  return {
    name: limits.force,
    here: say(limits.timesWeight, { ratio: formatWide(forceRatio, 2) }),
    means: limits.atOnePoint,
    exceeded: false,
  };
}

function losses({ lossRatio, exceeded: { lossRatio: exceeded } }: Validity): Limit {
  const { limits } = words;
  return {
    name: limits.losses,
    here: lossRatio < 5e-4 ? "0 %" : `${formatWide(100 * lossRatio, 2)} %`,
    means: exceeded ? limits.lossless : limits.loses,
    exceeded,
  };
}
