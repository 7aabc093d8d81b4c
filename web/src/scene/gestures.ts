// Gestures with mouse, pen and fingers: on the body they grasp it, elsewhere they turn the view. A finger
// grasps the body after it has rested on it; one that moves up or down at once scrolls the page as usual.

import type { Hands } from "./hands";
import type { View } from "./view";

/** rad per pixel */
const TURN = 0.006;
/** A finger holds the body after resting on it for this time, ms, and moving less than this, px. */
const [REST, STILL] = [220, 8];
/** A delay by more than this is that of a busy machine, ms. */
const LATE = 50;

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
  /** Says how a finger takes the body, after one that did not. */
  hint: () => void,
): void {
  const fingers = new Map<number, { x: number; y: number }>();
  let grasped: Grasped | undefined;
  let holder: number | undefined;
  /** A finger that rests on the body and will hold it. */
  let resting: { finger: number; on: Grasped; timer: number; x: number; y: number } | undefined;

  const spread = () => {
    const [a, b] = [...fingers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  };
  const grasp = (pointer: number, body: Grasped) => {
    grasped = body;
    holder = pointer;
    hands.take();
    canvas.classList.add("holding");
  };
  /** The finger has moved or lifted too early. */
  const slipOff = () => {
    if (!resting) return;
    clearTimeout(resting.timer);
    resting = undefined;
    hint();
  };
  const rest = (finger: number, on: Grasped, x: number, y: number) => {
    const due = performance.now() + REST;
    const hold = () => {
      // On a busy machine, moves that came in time may still be waiting.
      if (resting && performance.now() > due + LATE && !late) {
        late = true;
        resting.timer = window.setTimeout(hold, LATE);
        return;
      }
      resting = undefined;
      navigator.vibrate?.(10);
      grasp(finger, on);
      changed();
    };
    let late = false;
    resting = { finger, on, timer: window.setTimeout(hold, REST), x, y };
  };

  canvas.addEventListener("pointerdown", (event) => {
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    canvas.setPointerCapture(event.pointerId);
    if (fingers.size > 1) return slipOff();
    if (event.button !== 0) return;
    const body = bodyAt(event.offsetX, event.offsetY);
    if (!body) return;
    if (event.pointerType === "touch") rest(event.pointerId, body, event.clientX, event.clientY);
    else grasp(event.pointerId, body);
  });

  canvas.addEventListener("pointermove", (event) => {
    const finger = fingers.get(event.pointerId);
    if (!finger) {
      canvas.classList.toggle("over", bodyAt(event.offsetX, event.offsetY) !== undefined);
      return;
    }
    const [dx, dy] = [event.clientX - finger.x, event.clientY - finger.y];
    if (resting && Math.hypot(event.clientX - resting.x, event.clientY - resting.y) > STILL)
      slipOff();
    const before = spread();
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (grasped && event.pointerId === holder) {
      const { x, y } = grasped.lean(dx, dy);
      hands.push(x, y);
    } else if (!grasped && !resting) {
      const many = fingers.size > 1;
      view.turn((many ? -0.5 : -1) * dx * TURN, (many ? 0.5 : 1) * dy * TURN);
      if (many && before > 0) view.zoom(before / Math.max(spread(), 1));
    }
    changed();
  });

  const lift = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    slipOff();
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
    if ((hands.holding || event.touches.length > 1) && event.cancelable) event.preventDefault();
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

// Keys that do what gestures do, while the picture has the focus.

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
