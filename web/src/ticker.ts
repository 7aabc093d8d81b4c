// Lets time pass while the clock plays: once a picture, and not at all while it rests or the page is
// hidden, when the browser gives no pictures.

import { effect } from "@preact/signals-core";
import type { Clock } from "./clock";

/** A pause of the page is not made up for: no picture passes over more than this, s. */
const LONGEST = 0.1;

export function startTicker(clock: Clock): void {
  let before: number | undefined;
  const tick = (now: number) => {
    if (!clock.playing.peek()) {
      before = undefined;
      return;
    }
    try {
      if (before !== undefined) clock.advance(Math.min((now - before) / 1000, LONGEST));
    } catch (error) {
      // Whoever presses play again is to be heard.
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
