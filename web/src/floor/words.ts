// What the verdict says of a motion on a floor that moves.

import type { Motion } from "../core/motion";
import { formatDegrees, significant } from "../format/numbers";
import { formatDuration } from "../format/times";
import { BODY_NOUNS } from "../setup/fields";
import type { Setup } from "../setup/setup";
import type { Content } from "../verdict/content";
import type { Shaking } from "./shaking";

export function shakenVerdict(
  motion: Motion,
  shaking: Shaking,
  balanceTilt: number,
  setup: Readonly<Setup>,
): Partial<Content> {
  const tilt = largestTilt(motion);
  const uplift = timeOf(motion, "uplift");
  const ratio = significant(tilt / balanceTilt, 2);
  const noun = BODY_NOUNS[setup.body];
  const stood = setup.start === "standing";
  const rocks = tilt > 0 ? ` Its largest tilt is ${formatDegrees(tilt, 1)}.` : "";
  return {
    theory: {
      name: "Balance tilt",
      number: formatDegrees(balanceTilt, 1),
      note: "beyond it a body at rest falls over",
    },
    lowest: {
      name: "Largest tilt",
      number: formatDegrees(tilt, 1),
      note: balanceTilt > 0 ? `${ratio} of the balance tilt` : "",
    },
    then: {
      name: "Uplift",
      number: uplift === undefined ? "–" : formatDuration(uplift),
      note: stood
        ? uplift === undefined
          ? "it never begins to rock"
          : "when it begins to rock"
        : "the body leans at the start",
    },
    said: `${floorInWords(motion, shaking)} ${begins(uplift, motion, noun, stood)}${rocks}`,
    ...ended(motion, noun, balanceTilt),
  };
}

/** Sentences on the way in which the motion ends; nothing where the words for a table at rest hold. */
function ended(motion: Motion, noun: string, balanceTilt: number): Partial<Content> {
  const after = formatDuration(motion.end);
  const isBeyond = (motion.at([motion.end]).column("tilt")[0] ?? 0) > balanceTilt;
  switch (motion.status) {
    case "toppled":
      return { ended: `The ${noun} overturns at ${after}.` };
    case "lifted_off":
      return isBeyond
        ? { ended: `The ${noun} overturns: its rim leaves the floor at ${after}.` }
        : {};
    case "finished":
      if (isBeyond)
        return {
          ended: `It is beyond its balance tilt after ${after}, when the computation ends: whether it overturns is undecided.`,
        };
      return {
        ended: `It does not overturn. ${STILL[motion.phases.at(-1)?.kind ?? ""] ?? "It still moves"} after ${after}, when the computation ends.`,
      };
    case "face_down":
      return {
        ended: `The base comes down flat after ${after}, and the motion ends, because “Flat landing” says so. Rigid-body mechanics does not determine what follows.`,
      };
    default:
      return {};
  }
}

const STILL: Record<string, string> = {
  standing: "It stands flat",
  sliding_flat: "It still slides on its base",
  flying_level: "It is in the air",
};

/** How far the floor moves, in the time that the motion takes. */
function floorInWords(motion: Motion, shaking: Shaking): string {
  const times = Float64Array.from({ length: 501 }, (_, k) => (k / 500) * motion.end);
  const table = shaking.at(times);
  let [far, strong] = [0, 0];
  for (let k = 0; k < times.length; k++) {
    const size = (name: "acceleration" | "displacement") =>
      Math.hypot(
        ...(["x", "y", "z"] as const).map((axis) => table[`ground_${name}_${axis}`][k] ?? 0),
      );
    far = Math.max(far, size("displacement"));
    strong = Math.max(strong, size("acceleration"));
  }
  if (strong === 0) return "The floor does not move.";
  return `The floor moves by up to ${significant(100 * far, 2)} cm, at up to ${significant(strong, 2)} m/s².`;
}

function begins(uplift: number | undefined, motion: Motion, noun: string, stood: boolean): string {
  if (uplift !== undefined)
    return stood
      ? `The ${noun} begins to rock at ${formatDuration(uplift)} (uplift).`
      : `The ${noun} leans at first; it stands flat for a while and begins to rock again at ${formatDuration(uplift)}.`;
  if (!stood) return `The ${noun} leans at first.`;
  const slides = motion.phases.some(({ kind }) => kind === "sliding_flat");
  return slides
    ? `The ${noun} slides on its base and never begins to rock.`
    : `The ${noun} stands still on the floor and never begins to rock.`;
}

const timeOf = (motion: Motion, kind: string) =>
  motion.events.find((event) => event.kind === kind)?.moment.t;

/** The largest tilt, rad: at a maximum, at the start or at the end. */
export function largestTilt(motion: Motion): number {
  const ends = motion.at([0, motion.end]).column("tilt");
  const maxima = motion.events.map(({ moment }) => moment.tilt);
  return Math.max(...ends, ...maxima);
}
