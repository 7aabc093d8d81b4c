// The one picture of the essay. It moves to the scene that is in view, so that there is one graphics context, and
// leaves a still in the scene that it comes from.

import { effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { type Frame, frameIn } from "../scene/frame";
import { listen, listenToKeys } from "../scene/gestures";
import { Hands } from "../scene/hands";
import { onTheme } from "../scene/palette";
import type { Picture } from "../scene/picture";
import "../scene/scene.css";
import { words } from "../words/words";

export class EssayStage {
  readonly frame: Frame;
  /** Whether the body can be grasped in the present scene. */
  graspable = false;
  private picture: Picture | undefined;
  private readonly ends: (() => void)[] = [];
  private closed = false;

  /** `ready` is called when the picture is there. */
  constructor(
    private readonly lab: Lab,
    ready: () => void,
  ) {
    this.frame = frameIn(document.createElement("div"));
    import("../scene/picture")
      .then(({ Picture }) => {
        if (this.closed) return;
        this.picture = new Picture(lab, this.frame);
        this.connect(this.picture);
        ready();
      })
      .catch((error: unknown) => {
        console.warn(error);
        this.frame.stage.classList.add("blind");
        this.frame.notice.textContent = words.essay.noPicture;
      });
  }

  get hasPicture(): boolean {
    return this.picture !== undefined;
  }

  /** Moves to a place, with the view of the present set-up. */
  moveTo(place: HTMLElement): void {
    const { frame, lab, picture } = this;
    place.append(frame.stage);
    const { canvas } = frame;
    canvas.tabIndex = this.graspable ? 0 : -1;
    canvas.setAttribute("role", this.graspable ? "application" : "img");
    canvas.setAttribute("aria-label", this.graspable ? words.essay.theCan : words.essay.theBody);
    if (!picture) return;
    picture.view.cut(lab.view.peek());
    picture.resize();
  }

  /** Copies the present picture. */
  copyTo(still: HTMLCanvasElement): void {
    this.picture?.copyTo(still);
  }

  /** Frees the graphics context. */
  close(): void {
    this.closed = true;
    for (const end of this.ends) end();
    this.picture?.dispose();
    this.frame.stage.remove();
  }

  private connect(picture: Picture): void {
    const { lab, frame } = this;
    const { canvas, stage } = frame;
    const { changed, view } = picture;
    const hands = new Hands(lab);
    const bodyAt: Picture["bodyAt"] = (x, y) => (this.graspable ? picture.bodyAt(x, y) : undefined);
    const hint = () => {
      if (this.graspable) frame.tip.hidden = false;
    };
    listen(canvas, view, hands, bodyAt, changed, hint);
    listenToKeys(canvas, view, () => view.show(lab.view.peek()), hands, changed);
    this.ends.push(
      effect(() => {
        void [lab.setup.value, lab.outcome.value, lab.clock.time.value, lab.marks.value];
        void [lab.held.value, lab.flicks.value, lab.flicksShown.value, lab.view.value];
        changed();
      }),
    );
    addEventListener("beforeprint", picture.print);
    const sizes = new ResizeObserver(picture.resize);
    sizes.observe(stage);
    this.ends.push(
      onTheme(picture.repaint),
      () => sizes.disconnect(),
      () => removeEventListener("beforeprint", picture.print),
    );
    canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", picture.restore);
  }
}
