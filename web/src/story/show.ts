// Sets the lab up for a step of the story and lets it happen.

import { batch } from "@preact/signals-core";
import { clearThem, makeThem } from "../falls/making";
import type { Lab } from "../lab";
import { INITIAL } from "../setup/setup";
import type { Step } from "./steps";

/** Not `moving`, it shows what comes of the release: the end of its first turn. */
export function show(lab: Lab, step: Step, moving: boolean): void {
  const { clock } = lab;
  batch(() => {
    clearThem(lab);
    lab.change({ ...INITIAL, ...step.setup });
    clock.speed.value = step.speed;
    clock.stretched.value = step.stretched;
    // Also when it is set up already.
    clock.pause();
    clock.rewind();
  });
  // Not while it is watched.
  lab.complete();
  if (step.shows === "flicks") makeThem(lab);
  if (moving) clock.play();
  else clock.time.value = lab.motion.value?.turns[0]?.end ?? clock.end;
}
