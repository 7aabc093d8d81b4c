// The scene: the body on a table in three dimensions, and a visitor's hands.

import { effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { type Frame, frameIn } from "./frame";
import { listen } from "./gestures";
import { Hands } from "./hands";
import { listenToKeys } from "./keys";
import { onTheme } from "./palette";
import { Picture } from "./picture";
import "./scene.css";

export function mountScene(lab: Lab, place: HTMLElement): void {
  const frame = frameIn(place);
  const picture = pictureIn(lab, frame);
  if (!picture) return;
  const { canvas, stage } = frame;
  const hands = new Hands(lab);
  listen(canvas, picture.view, hands, picture.bodyAt, picture.changed);
  listenToKeys(canvas, picture.view, hands, picture.changed);
  frame.reset.addEventListener("click", () => {
    picture.view.reset();
    picture.changed();
  });
  frame.above.addEventListener("click", () => {
    picture.view.fromAbove();
    picture.changed();
  });
  effect(() => {
    // Whatever of these changes, it is to be drawn.
    void [lab.setup.value, lab.outcome.value, lab.clock.time.value];
    void [lab.held.value, lab.flicks.value, lab.flicksMade.value];
    picture.changed();
  });
  onTheme(picture.repaint);
  new ResizeObserver(picture.resize).observe(stage);
}

/** Nothing, and a word to the visitor, where there is no WebGL. */
function pictureIn(lab: Lab, frame: Frame): Picture | undefined {
  const say = (text: string) => {
    frame.notice.textContent = text;
    frame.stage.classList.toggle("blind", text !== "");
  };
  try {
    const picture = new Picture(lab, frame);
    frame.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      say("The graphics of this browser have stopped; the picture comes back when they do.");
    });
    frame.canvas.addEventListener("webglcontextrestored", () => {
      say("");
      picture.repaint();
    });
    return picture;
  } catch {
    say(
      "This browser shows no three-dimensional pictures (WebGL is off or missing). " +
        "All else on this page works: the motion, the angles and the plots.",
    );
    return undefined;
  }
}
