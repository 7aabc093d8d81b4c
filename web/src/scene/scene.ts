// The scene: the body on a table in three dimensions, and a visitor's hands.

import { effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { type Frame, frameIn } from "./frame";
import { listen } from "./gestures";
import { Hands } from "./hands";
import { listenToKeys } from "./keys";
import { onTheme } from "./palette";
import type { Picture } from "./picture";
import "./scene.css";

// The largest part of the page comes beside the others, which need not wait for it.
const coming = import("./picture");

export function mountScene(lab: Lab, place: HTMLElement): void {
  const frame = frameIn(place);
  const say = (text: string) => {
    frame.notice.textContent = text;
    frame.stage.classList.toggle("blind", text !== "");
  };
  const without = (why: string) => (error: unknown) => {
    console.warn(error);
    say(`${why} All else on this page works: the motion, the angles and the plots.`);
  };
  const draw = ({ Picture }: Awaited<typeof coming>) => {
    const picture = new Picture(lab, frame);
    connect(lab, frame, picture);
    surviveLoss(frame, picture, say);
  };
  coming
    .then(draw, without("The picture could not be loaded; to see it, load the page again."))
    .catch(without("This browser shows no three-dimensional pictures (WebGL is off or missing)."));
}

function connect(lab: Lab, { canvas, stage, reset, above }: Frame, picture: Picture): void {
  const { view, changed } = picture;
  const hands = new Hands(lab);
  listen(canvas, view, hands, picture.bodyAt, changed);
  listenToKeys(canvas, view, hands, changed);
  reset.addEventListener("click", () => {
    view.reset();
    changed();
  });
  above.addEventListener("click", () => {
    view.fromAbove();
    changed();
  });
  effect(() => {
    // Whatever of these changes, it is to be drawn.
    void [lab.setup.value, lab.outcome.value, lab.clock.time.value];
    void [lab.held.value, lab.flicks.value, lab.flicksShown.value];
    changed();
  });
  onTheme(picture.repaint);
  new ResizeObserver(picture.resize).observe(stage);
}

/** The graphics card may be taken away and given back, as when a laptop sleeps. */
function surviveLoss({ canvas }: Frame, picture: Picture, say: (text: string) => void): void {
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    say("The graphics of this browser have stopped; the picture comes back when they do.");
  });
  canvas.addEventListener("webglcontextrestored", () => {
    say("");
    picture.restore();
  });
}
