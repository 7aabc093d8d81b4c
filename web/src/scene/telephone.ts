// The telephone as the hand: while one holds a button, the body tips as the telephone does, and letting go of the
// button lets go of the body. The button appears where there is a sensor of the orientation.

import { effect, type ReadonlySignal } from "@preact/signals-core";
import { button, element } from "../elements";
import type { Lab } from "../lab";
import type { Lean } from "../setup/release";
import { words } from "../words/words";
import { Hands } from "./hands";

/** The angles of a DeviceOrientationEvent about the telephone's x and y axes, degrees. */
export interface Orientation {
  beta: number | null;
  gamma: number | null;
}

/** Where browsers ask the visitor before they tell the orientation. */
interface Asking {
  requestPermission?: () => Promise<"granted" | "denied">;
}

const DEGREE = Math.PI / 180;

/** How a telephone leans from lying on its back, as a vector along its screen: x to the right, y away from the reader,
 * rad. `turned` is the angle of the screen's orientation, degrees. Undefined without a sensor. */
export function leanOf({ beta, gamma }: Orientation, turned: number): Lean | undefined {
  if (beta === null || gamma === null) return undefined;
  const [b, g, t] = [beta * DEGREE, gamma * DEGREE, turned * DEGREE];
  // The horizontal part of the direction in which the screen faces, along the telephone's axes: the third row of
  // Z(alpha) X(beta) Y(gamma) of the W3C, with its sign changed.
  const [x, y] = [Math.cos(b) * Math.sin(g), -Math.sin(b)];
  const aside = Math.hypot(x, y);
  const tilt = Math.atan2(aside, Math.cos(b) * Math.cos(g));
  const size = aside > 0 ? tilt / aside : 0;
  return {
    x: size * (x * Math.cos(t) - y * Math.sin(t)),
    y: size * (x * Math.sin(t) + y * Math.cos(t)),
  };
}

/** A vector along the screen as one on the table, which is seen from an azimuth, rad. */
export function ontoTable({ x, y }: Lean, azimuth: number): Lean {
  const [c, s] = [Math.cos(azimuth), Math.sin(azimuth)];
  return { x: -s * x - c * y, y: c * x - s * y };
}

/** The place of the button. While `active`, it looks for a sensor. Where a browser may have to ask before there is one, a
 * button does that. */
export function telephoneButton(lab: Lab, active: ReadonlySignal<boolean>): HTMLElement {
  const place = element("div", { class: "telephone" });
  const hold = holdButton(lab);
  const found = (event: DeviceOrientationEvent) => {
    if (!leanOf(event, 0)) return;
    place.replaceChildren(hold);
    removeEventListener("deviceorientation", found);
  };
  effect(() => {
    if (active.value && !hold.isConnected) addEventListener("deviceorientation", found);
    return () => removeEventListener("deviceorientation", found);
  });
  const { requestPermission } = (globalThis.DeviceOrientationEvent ?? {}) as Asking;
  // Some browsers without a sensor can be asked, too.
  if (requestPermission && matchMedia("(pointer: coarse)").matches) {
    const ask = button(words.essay.askTelephone, () => {
      requestPermission.call(DeviceOrientationEvent).then(
        (answer) => answer === "denied" && ask.remove(),
        () => ask.remove(),
      );
    });
    place.append(ask);
  }
  return place;
}

function holdButton(lab: Lab): HTMLButtonElement {
  const hands = new Hands(lab);
  const made = element("button", { type: "button" }, words.essay.holdTelephone);
  let before: Lean | undefined;
  let finger: number | undefined;
  const move = (event: DeviceOrientationEvent) => {
    const lean = leanOf(event, screen.orientation?.angle ?? 0);
    if (!lean) return;
    const by = before ? { x: lean.x - before.x, y: lean.y - before.y } : { x: 0, y: 0 };
    before = lean;
    const { x, y } = ontoTable(by, lab.azimuth);
    hands.push(x, y);
  };
  made.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || finger !== undefined) return;
    finger = event.pointerId;
    made.setPointerCapture(event.pointerId);
    before = undefined;
    hands.take();
    addEventListener("deviceorientation", move);
  });
  const letGo = (event: PointerEvent) => {
    if (event.pointerId !== finger) return;
    finger = undefined;
    removeEventListener("deviceorientation", move);
    if (event.type === "pointerup") hands.release();
    else hands.cancel();
  };
  made.addEventListener("pointerup", letGo);
  made.addEventListener("pointercancel", letGo);
  // A long touch opens no menu.
  made.addEventListener("contextmenu", (event) => event.preventDefault());
  return made;
}
