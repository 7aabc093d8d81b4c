// Advances the clock once per frame while it plays. While the page is hidden, the browser draws no
// frames, so time stands still.

import { effect } from "@preact/signals-core";
import type { Clock } from "./clock";
import { advanceFrame } from "./frames";

/** Longest time that one frame advances, s: time lost while the page was paused is not made up. */
const MAX_FRAME = 0.1;

export function startTicker(clock: Clock): void {
  let before: number | undefined;
  const tick = (now: number) => {
    if (!clock.playing.peek()) {
      before = undefined;
      return;
    }
    try {
      const passed = before === undefined ? 0 : Math.min((now - before) / 1000, MAX_FRAME);
      advanceFrame(now, () => clock.advance(passed));
    } catch (error) {
      // Pressing play again must start it again.
      before = undefined;
      clock.pause();
      throw error;
    }
    before = now;
    requestAnimationFrame(tick);
  };
  effect(() => {
    if (clock.playing.value && before === undefined) {
      before = performance.now();
      requestAnimationFrame(tick);
    }
  });
}
