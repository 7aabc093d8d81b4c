// Gestures with mouse, pen and fingers: on the body they grasp it, elsewhere they turn the view. On a
// phone a finger that moves up or down beside the body scrolls the page as usual.

import type { Hands } from "./hands";
import type { View } from "./view";

/** rad per pixel */
const TURN = 0.006;

export interface Grasped {
  /** Converts a movement on the screen, px, into a change of the lean, rad. */
  lean(dx: number, dy: number): { x: number; y: number };
}

export function listen(
  canvas: HTMLCanvasElement,
  view: View,
  hands: Hands,
  /** The body, if it is at a place of the canvas. */
  bodyAt: (x: number, y: number) => Grasped | undefined,
  changed: () => void,
): void {
  const fingers = new Map<number, { x: number; y: number }>();
  let grasped: Grasped | undefined;
  let holder: number | undefined;

  const spread = () => {
    const [a, b] = [...fingers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  };

  canvas.addEventListener("pointerdown", (event) => {
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    canvas.setPointerCapture(event.pointerId);
    if (fingers.size === 1 && event.button === 0) {
      grasped = bodyAt(event.offsetX, event.offsetY);
      if (grasped) {
        holder = event.pointerId;
        hands.take();
      }
    }
    canvas.classList.toggle("holding", grasped !== undefined);
  });

  canvas.addEventListener("pointermove", (event) => {
    const finger = fingers.get(event.pointerId);
    if (!finger) {
      canvas.classList.toggle("over", bodyAt(event.offsetX, event.offsetY) !== undefined);
      return;
    }
    const [dx, dy] = [event.clientX - finger.x, event.clientY - finger.y];
    const before = spread();
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (grasped && event.pointerId === holder) {
      const { x, y } = grasped.lean(dx, dy);
      hands.push(x, y);
    } else if (!grasped) {
      const many = fingers.size > 1;
      view.turn((many ? -0.5 : -1) * dx * TURN, (many ? 0.5 : 1) * dy * TURN);
      if (many && before > 0) view.zoom(before / Math.max(spread(), 1));
    }
    changed();
  });

  const lift = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    if (grasped && event.pointerId === holder) {
      grasped = holder = undefined;
      if (event.type === "pointerup") hands.release();
      else hands.cancel();
      canvas.classList.remove("holding");
    }
    changed();
  };
  canvas.addEventListener("pointerup", lift);
  canvas.addEventListener("pointercancel", lift);

  // The page must not scroll under a finger that holds the body or under two fingers.
  const stay = (event: TouchEvent) => {
    const rect = canvas.getBoundingClientRect();
    const first = event.touches[0];
    const on = first && bodyAt(first.clientX - rect.left, first.clientY - rect.top);
    if ((on || hands.holding || event.touches.length > 1) && event.cancelable)
      event.preventDefault();
  };
  canvas.addEventListener("touchstart", stay, { passive: false });
  canvas.addEventListener("touchmove", stay, { passive: false });

  canvas.addEventListener(
    "wheel",
    (event) => {
      // Before a click on the picture the wheel scrolls the page.
      if (!event.ctrlKey && document.activeElement !== canvas) return;
      event.preventDefault();
      const pixels = event.deltaMode === 1 ? 30 * event.deltaY : event.deltaY;
      view.zoom(Math.exp(Math.min(Math.max(pixels, -240), 240) * 0.0012));
      changed();
    },
    { passive: false },
  );
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
}
