// The paper in six steps, each with a text and a set-up of the lab.

import type { Playback } from "../setup/playback";
import { BY_HAND, HAND_ERROR, INITIAL, type Setup } from "../setup/setup";
import { words } from "../words/words";
import { batch } from "@preact/signals-core";
import { clearFlicks, startFlicks } from "../falls/shown";
import type { Lab } from "../lab";

export interface Step extends Playback {
  title: string;
  text: string;
  /** MathML, and what its symbols mean. */
  formula?: string;
  symbols?: string;
  /** Fields that differ from the initial set-up. */
  setup: Partial<Setup>;
  /** Whether the step shows one release or many flicks. */
  shows: "release" | "flicks";
}

const FLICK: Partial<Setup> = { tilt_rate: -5, sideways: HAND_ERROR, duration: 2 };

/** The limiting turn without slip (Srinivasan & Ruina 2008). */
const LIMIT =
  '<math display="block"><mi>π</mi><msqrt><mfrac>' +
  "<mrow><mi>A</mi><mo>+</mo><mi>m</mi><msup><mi>R</mi><mn>2</mn></msup><mo>+</mo><mi>m</mi><msup><mi>H</mi><mn>2</mn></msup></mrow>" +
  "<mrow><mi>A</mi><mo>+</mo><mi>m</mi><msup><mi>H</mi><mn>2</mn></msup></mrow>" +
  "</mfrac></msqrt></math>";

export const STEPS: readonly Step[] = [
  {
    ...words.story.steps.looks,
    setup: BY_HAND,
    speed: 1,
    stretched: false,
    view: "whole",
    shows: "release",
  },
  {
    ...words.story.steps.slower,
    setup: { tilt: 5, sideways: HAND_ERROR },
    speed: 0.02,
    stretched: false,
    view: "whole",
    shows: "release",
  },
  {
    ...words.story.steps.rolls,
    setup: {},
    speed: 1,
    stretched: true,
    view: "contact",
    shows: "release",
  },
  {
    ...words.story.steps.same,
    formula: LIMIT,
    setup: { law: "no_slip", unsteadiness: 10 },
    speed: 1,
    stretched: true,
    view: "whole",
    shows: "flicks",
  },
  {
    ...words.story.steps.friction,
    setup: { ...FLICK, law: "coulomb", friction: 0.12 },
    speed: 1,
    stretched: true,
    view: "whole",
    shows: "flicks",
  },
  {
    ...words.story.steps.yourTurn,
    setup: BY_HAND,
    speed: 1,
    stretched: true,
    view: "whole",
    shows: "release",
  },
];

// Sets the lab up for a step of the story and plays it.

/** Plays up to the end of the first turn, after which the motion repeats itself. Without `moving` it
 * shows that moment at once. */
export function showStep(lab: Lab, step: Step, moving: boolean): void {
  const { clock } = lab;
  batch(() => {
    clearFlicks(lab);
    lab.compare(undefined, { ...INITIAL, ...step.setup });
    lab.setPlayback(step);
    // Restart even if the set-up is unchanged.
    clock.pause();
    clock.rewind();
  });
  // Compute the rest now, not while the motion is playing.
  lab.complete();
  if (step.shows === "flicks") startFlicks(lab);
  const turnEnd = lab.motion.value?.turns[0]?.end ?? clock.end;
  if (moving) clock.play(turnEnd);
  else clock.time.value = turnEnd;
}
