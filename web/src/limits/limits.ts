// The limits of the model in words, with the numbers of a motion.

import { formatDuration, formatLengthShort, formatSpeed, formatWide } from "../format";
import { element } from "../elements";
import type { Motion, Validity } from "../core/motion";
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

/** A limit as an entry of a list. */
export const entryOf = ({ name, here, means, exceeded }: Limit): HTMLElement =>
  element(
    "div",
    { class: exceeded ? "exceeded" : "held" },
    element("dt", {}, name),
    element("dd", { class: "here" }, here),
    element("dd", { class: "means" }, means),
  );

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

// How long a base is nearer to the table than their unevenness.

export interface Touching {
  /** s */
  time: number;
  /** Angle through which the contact point runs meanwhile, rad. */
  angle: number;
}

/** The part of a motion from `start` to `end` (s) during which the highest point of the rim, whose radius is in m, is lower than a
 * unevenness (m). Undefined if there is none. */
export function touching(
  motion: Motion,
  { start, end }: { start: number; end: number },
  radius: number,
  unevenness: number,
): Touching | undefined {
  const moments = motion.curve();
  const [t, tilt, yaw] = [moments.column("t"), moments.column("tilt"), moments.column("yaw")];
  let [time, angle] = [0, 0];
  for (let k = 1; k < moments.length; k++) {
    const [from, to] = [t[k - 1]!, t[k]!];
    const inside = Math.min(to, end) - Math.max(from, start);
    if (inside <= 0) continue;
    const low = partBelow(tilt[k - 1]!, tilt[k]!, unevenness / (2 * radius));
    const part = low * (inside / (to - from));
    time += part * (to - from);
    angle += part * Math.abs(yaw[k]! - yaw[k - 1]!);
  }
  return time > 0 ? { time, angle } : undefined;
}

/** The part of a straight line between two values that is below a limit. */
function partBelow(a: number, b: number, limit: number): number {
  const [low, high] = [Math.min(a, b), Math.max(a, b)];
  if (high <= limit) return 1;
  return low >= limit ? 0 : (limit - low) / (high - low);
}
