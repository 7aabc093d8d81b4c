// Work for the next frame of the screen, or for the present one while time advances in it, so that the
// picture and the numbers show the same moment.

type Act = (now: number) => void;

/** What is to be done in the present frame; undefined between frames. */
let waiting: Act[] | undefined;

/** Does something in the present frame, after time has advanced, or else in the next one. */
export function inFrame(act: Act): void {
  if (waiting) waiting.push(act);
  else requestAnimationFrame(act);
}

/** Advances in a frame at a time (ms), and then does what has been asked for meanwhile. */
export function advanceFrame(now: number, advance: () => void): void {
  waiting = [];
  try {
    advance();
  } finally {
    const acts = waiting;
    waiting = undefined;
    for (const act of acts) act(now);
  }
}
