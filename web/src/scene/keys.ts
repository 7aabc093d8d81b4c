// The same with keys, when the picture is focused.

import type { Hands } from "./hands";
import type { View } from "./view";

const DEGREE = Math.PI / 180;

/** What the keys do, for whoever asks. */
export const KEYS: readonly (readonly [key: string, does: string])[] = [
  ["← → ↑ ↓", "go round the table"],
  ["Page Up, Page Down", "nearer, farther"],
  ["Home", "the usual view"],
  ["+ and −", "take the body and tip it by a degree"],
  ["Shift + ← →", "lead it round while you hold it"],
  ["Enter", "let it go at rest"],
  ["Shift + Enter", "flick it, with the tilt rate and the twist that are set"],
  ["Escape", "put it back"],
];

export function listenToKeys(
  canvas: HTMLCanvasElement,
  view: View,
  hands: Hands,
  changed: () => void,
): void {
  const hold = (move: () => void) => {
    if (!hands.holding) hands.take();
    move();
  };
  const sideways = (sign: number, shift: boolean) =>
    shift ? hold(() => hands.round(sign * 5 * DEGREE)) : view.turn(-sign * 0.08, 0);
  const actions: Record<string, (shift: boolean) => void> = {
    ArrowLeft: (shift) => sideways(-1, shift),
    ArrowRight: (shift) => sideways(1, shift),
    ArrowUp: () => view.turn(0, 0.06),
    ArrowDown: () => view.turn(0, -0.06),
    PageUp: () => view.zoom(0.9),
    PageDown: () => view.zoom(1 / 0.9),
    Home: () => view.reset(),
    "+": () => hold(() => hands.tip(DEGREE)),
    "=": () => hold(() => hands.tip(DEGREE)),
    "-": () => hold(() => hands.tip(-DEGREE)),
    "−": () => hold(() => hands.tip(-DEGREE)),
    Enter: (shift) => (shift ? hands.flick() : hands.release(false)),
    Escape: () => hands.cancel(),
  };
  canvas.addEventListener("keydown", (event) => {
    const action = actions[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    action(event.shiftKey);
    changed();
  });
  // Who goes on to another control has let the body stand as it was.
  canvas.addEventListener("blur", () => hands.cancel());
}
