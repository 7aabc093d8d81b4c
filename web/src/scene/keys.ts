// Keys that do what gestures do, while the picture has the focus.

import type { Hands } from "./hands";
import type { View } from "./view";

const DEGREE = Math.PI / 180;

export function listenToKeys(
  canvas: HTMLCanvasElement,
  view: View,
  reset: () => void,
  hands: Hands,
  changed: () => void,
): void {
  const hold = (move: () => void) => {
    if (!hands.holding) hands.take();
    move();
  };
  const sideways = (sign: number, shift: boolean) =>
    shift ? hold(() => hands.swing(sign * 5 * DEGREE)) : view.turn(-sign * 0.08, 0);
  const actions: Record<string, (shift: boolean) => void> = {
    ArrowLeft: (shift) => sideways(-1, shift),
    ArrowRight: (shift) => sideways(1, shift),
    ArrowUp: () => view.turn(0, 0.06),
    ArrowDown: () => view.turn(0, -0.06),
    PageUp: () => view.zoom(0.9),
    PageDown: () => view.zoom(1 / 0.9),
    Home: reset,
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
  // When the focus moves to another control, the body is put back.
  canvas.addEventListener("blur", () => hands.cancel());
}
