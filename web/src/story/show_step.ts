// Sets the lab up for a step of the story and lets it happen.

import { batch } from "@preact/signals-core";
import { clearFlicks, startFlicks } from "../falls/animation";
import type { Lab } from "../lab";
import { INITIAL } from "../setup/setup";
import type { Step } from "./steps";

/** Plays up to the first rise, where the body has come up again: what comes after repeats it. Not
 * `moving`, it shows that moment at once. */
export function showStep(lab: Lab, step: Step, moving: boolean): void {
  const { clock } = lab;
  batch(() => {
    clearFlicks(lab);
    lab.change({ ...INITIAL, ...step.setup });
    clock.speed.value = step.speed;
    clock.stretched.value = step.stretched;
    // Also when it is set up already.
    clock.pause();
    clock.rewind();
  });
  // Not while it is watched.
  lab.complete();
  if (step.shows === "flicks") startFlicks(lab);
  const risen = lab.motion.value?.turns[0]?.end ?? clock.end;
  if (moving) clock.play(risen);
  else clock.time.value = risen;
}
