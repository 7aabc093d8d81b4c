// What the verdict says of a motion on a floor that moves.

import type { Motion } from "../core/motion";
import { formatDegrees, formatDuration, significant } from "../format";
import type { BodyName } from "../setup/fields";
import type { Setup } from "../setup/setup";
import type { Content } from "../verdict/content";
import type { Shaking } from "./shaking";
import { say, sentences, words } from "../words/words";

export function shakenVerdict(
  motion: Motion,
  shaking: Shaking,
  balanceTilt: number,
  setup: Readonly<Setup>,
): Partial<Content> {
  const tilt = largestTilt(motion);
  const uplift = timeOf(motion, "uplift");
  const ratio = significant(tilt / balanceTilt, 2);
  const { body } = setup;
  const { floor } = words;
  const stood = setup.start === "standing";
  const rocks = tilt > 0 ? say(floor.itsLargestTilt, { tilt: formatDegrees(tilt, 1) }) : "";
  return {
    theory: {
      name: floor.balanceTilt,
      number: formatDegrees(balanceTilt, 1),
      note: floor.beyondBalance,
    },
    lowest: {
      name: floor.largestTilt,
      number: formatDegrees(tilt, 1),
      note: balanceTilt > 0 ? say(floor.ofBalance, { ratio }) : "",
    },
    then: {
      name: floor.uplift,
      number: uplift === undefined ? "–" : formatDuration(uplift),
      note: stood
        ? uplift === undefined
          ? floor.neverRocks
          : floor.whenRocks
        : floor.leansAtStart,
    },
    said: sentences(floorInWords(motion, shaking), begins(uplift, motion, body, stood), rocks),
    ...ended(motion, body, balanceTilt),
  };
}

/** Sentences on the way in which the motion ends; nothing where the words for a table at rest hold. */
function ended(motion: Motion, body: BodyName, balanceTilt: number): Partial<Content> {
  const after = formatDuration(motion.end);
  const isBeyond = (motion.at([motion.end]).column("tilt")[0] ?? 0) > balanceTilt;
  switch (motion.status) {
    case "toppled":
      return { ended: say(words.floor.overturns, { ...words.nouns[body], after }) };
    case "lifted_off":
      return isBeyond
        ? { ended: say(words.floor.overturnsInAir, { ...words.nouns[body], after }) }
        : {};
    case "finished":
      return {
        ended: isBeyond
          ? say(words.floor.undecided, { after })
          : say(words.floor.survives, {
              state: STILL[motion.phases.at(-1)?.kind ?? ""] ?? "moving",
              after,
            }),
      };
    case "face_down":
      return { ended: say(words.floor.stops, { after }) };
    default:
      return {};
  }
}

const STILL: Record<string, "standing" | "sliding_flat" | "flying_level"> = {
  standing: "standing",
  sliding_flat: "sliding_flat",
  flying_level: "flying_level",
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
  if (strong === 0) return words.floor.isStill;
  return say(words.floor.moves, {
    far: `${significant(100 * far, 2)} cm`,
    strong: `${significant(strong, 2)} m/s²`,
  });
}

function begins(
  uplift: number | undefined,
  motion: Motion,
  body: BodyName,
  stood: boolean,
): string {
  if (uplift !== undefined)
    return stood
      ? say(words.floor.beginsToRock, { ...words.nouns[body], at: formatDuration(uplift) })
      : say(words.floor.rocksAgain, { ...words.nouns[body], at: formatDuration(uplift) });
  if (!stood) return say(words.floor.leans, { ...words.nouns[body] });
  const slides = motion.phases.some(({ kind }) => kind === "sliding_flat");
  return slides
    ? say(words.floor.slides, { ...words.nouns[body] })
    : say(words.floor.stands, { ...words.nouns[body] });
}

const timeOf = (motion: Motion, kind: string) =>
  motion.events.find((event) => event.kind === kind)?.moment.t;

/** The largest tilt, rad: at a maximum, at the start or at the end. */
export function largestTilt(motion: Motion): number {
  const ends = motion.at([0, motion.end]).column("tilt");
  const maxima = motion.events.map(({ moment }) => moment.tilt);
  return Math.max(...ends, ...maxima);
}
