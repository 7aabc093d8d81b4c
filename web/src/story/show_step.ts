// Sets the lab up for a step of the story and plays it.

import { batch } from "@preact/signals-core";
import { clearFlicks, startFlicks } from "../falls/animation";
import type { Lab } from "../lab";
import { INITIAL } from "../setup/setup";
import type { Step } from "./steps";

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
