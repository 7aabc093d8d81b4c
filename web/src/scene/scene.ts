// The scene: the body on a table in three dimensions, which the visitor can grasp.

import { effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import type { ViewName } from "../setup/playback";
import { type Frame, frameIn } from "./frame";
import { listen, listenToKeys } from "./gestures";
import { Hands } from "./hands";
import { onTheme } from "./palette";
import type { Picture } from "./picture";
import "./scene.css";
import { sentences, words } from "../words/words";

// The largest part of the page is loaded in parallel, so that the other parts need not wait for it.
const loading = import("./picture");

export function mountScene(lab: Lab, place: HTMLElement): void {
  const frame = frameIn(place);
  const say = (text: string) => {
    frame.notice.textContent = text;
    frame.stage.classList.toggle("blind", text !== "");
  };
  const without = (why: string) => (error: unknown) => {
    console.warn(error);
    frame.stage.classList.add("never");
    say(sentences(why, words.scene.rest));
  };
  const draw = ({ Picture }: Awaited<typeof loading>) => {
    const picture = new Picture(lab, frame);
    connect(lab, frame, picture);
    handleContextLoss(frame, picture, say);
  };
  loading.then(draw, without(words.scene.notLoaded)).catch(without(words.scene.noWebGL));
}

/** A tip is shown for this time, ms, and so many times. */
const [TIP, MAX_TIPS] = [3000, 3];

function connect(lab: Lab, { canvas, stage, reset, places, tip }: Frame, picture: Picture): void {
  const { view, changed } = picture;
  const hands = new Hands(lab);
  listen(canvas, view, hands, picture.bodyAt, changed, tipFor(tip));
  const look = (name: ViewName) => {
    // Also if the visitor has turned away from there.
    view.show(name);
    lab.view.value = name;
    changed();
  };
  listenToKeys(canvas, view, () => look("whole"), hands, changed);
  reset.addEventListener("click", () => look("whole"));
  for (const [name, button] of places)
    button.addEventListener("click", () => look(lab.view.peek() === name ? "whole" : name));
  effect(() => {
    if (lab.view.value !== view.chosen) view.show(lab.view.value);
    for (const [name, button] of places)
      button.setAttribute("aria-pressed", String(name === lab.view.value));
    changed();
  });
  effect(() => {
    // A change of any of these signals redraws the scene.
    void [lab.setup.value, lab.outcome.value, lab.clock.time.value];
    void [lab.otherSetup.value, lab.other.outcome.value];
    void [lab.held.value, lab.tableHeld.value, lab.flicks.value, lab.flicksShown.value];
    changed();
  });
  onTheme(picture.repaint);
  addEventListener("beforeprint", picture.print);
  addEventListener("afterprint", () => stage.style.removeProperty("background-image"));
  new ResizeObserver(picture.resize).observe(stage);
}

/** Shows a tip for a while. */
function tipFor(tip: HTMLElement): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let times = 0;
  return () => {
    // Those who only scroll past need not be told again and again.
    if (++times > MAX_TIPS) return;
    tip.hidden = false;
    clearTimeout(timer);
    timer = setTimeout(() => (tip.hidden = true), TIP);
  };
}

/** Handles the loss of the graphics context, for example when a laptop sleeps, and its return. */
function handleContextLoss({ canvas }: Frame, picture: Picture, say: (text: string) => void): void {
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    say(words.scene.stopped);
  });
  canvas.addEventListener("webglcontextrestored", () => {
    say("");
    picture.restore();
  });
}
