// The picture of the body on the table and everything drawn round it, in layers. It is drawn only when something has
// changed.

import { Vector2 } from "three";
import type { Ghost } from "../compare/ghost";
import type { Lab } from "../lab";
import { say, words } from "../words/words";
import { inFrame } from "../timing";
import { BodyLayer } from "./body";
import { Dots } from "./dots";
import type { Frame } from "./frame";
import type { Grasped } from "./gestures";
import { type Instant, Instants, type Layer, LoadedLayer } from "./instant";
import { Labels } from "./labels";
import { formatLength } from "./measures";
import { readPalette } from "./palette";
import { PathLayer } from "./path";
import type { Spot } from "./pose";
import { PIXEL } from "./ribbon";
import { FrameRate, Stage } from "./stage";
import { cellOf, Tabletop } from "./tabletop";
import { TurnLayer } from "./turn";
import { View } from "./view";

export class Picture {
  readonly view: View;
  width = 0;
  height = 0;
  private readonly stage: Stage;
  private readonly labels: Labels;
  private readonly instants: Instants;
  private readonly body = new BodyLayer();
  /** The second motion. */
  private readonly ghost: LoadedLayer<Ghost>;
  /** In the order in which they are updated. */
  private readonly layers: readonly Layer[];
  private readonly frameRate = new FrameRate();
  /** What was drawn last. */
  private shown: Instant | undefined;
  /** Length of a pixel at distance 1, in units of the stage. */
  private pixel = 0;
  private waiting = false;
  private readonly pointed = new Vector2();

  /** Throws if the browser has no WebGL. */
  constructor(
    private readonly lab: Lab,
    private readonly frame: Frame,
  ) {
    this.stage = new Stage(frame.canvas);
    const { scene, camera } = this.stage;
    this.view = new View(camera);
    this.labels = new Labels(frame.words);
    this.instants = new Instants(lab, camera);
    this.ghost = new LoadedLayer(
      () => lab.otherSetup.peek() !== undefined,
      () => import("../compare/ghost").then(({ Ghost }) => new Ghost(lab, this.labels)),
      this.changed,
    );
    this.layers = [
      new Tabletop(scene, this.view, () => this.repaint()),
      this.body,
      new PathLayer(),
      new TurnLayer(this.labels, this.body),
      new Dots(),
      new LoadedLayer(
        ({ seeThrough }) => seeThrough,
        () => import("./closeup").then(({ Closeup }) => new Closeup(lab, frame.stage, this.labels)),
        this.changed,
      ),
      this.ghost,
    ];
    scene.add(...this.layers.map(({ group }) => group));
    this.repaint();
  }

  /** Requests a redraw in the next frame. */
  readonly changed = (): void => {
    if (this.waiting) return;
    this.waiting = true;
    inFrame((now) => {
      this.waiting = false;
      this.draw(now);
    });
  };

  /** Puts the present picture behind the canvas, which is blank on paper. */
  readonly print = (): void => {
    const { canvas, stage } = this.frame;
    this.draw(performance.now());
    stage.style.backgroundImage = `url(${canvas.toDataURL()})`;
  };

  /** Draws the present picture and copies it. */
  copyTo(still: HTMLCanvasElement): void {
    const { canvas } = this.frame;
    this.draw(performance.now());
    [still.width, still.height] = [canvas.width, canvas.height];
    if (canvas.width > 0 && canvas.height > 0) still.getContext("2d")?.drawImage(canvas, 0, 0);
  }

  /** Frees the graphics context; nothing can be drawn afterwards. */
  dispose(): void {
    this.waiting = true;
    this.stage.dispose();
  }

  readonly resize = (): void => {
    const { clientWidth, clientHeight } = this.frame.stage;
    [this.width, this.height] = [clientWidth, clientHeight];
    if (this.stage.fit(clientWidth, clientHeight)) this.changed();
  };

  /** Restores the graphics context after a loss. */
  readonly restore = (): void => {
    this.stage.buildEnvironment();
    this.repaint();
  };

  /** Applies changed colours. */
  readonly repaint = (): void => {
    const palette = readPalette();
    this.stage.paint(palette);
    for (const layer of this.layers) layer.paint(palette);
    this.changed();
  };

  /** The body, if it is at a place of the picture (px). */
  readonly bodyAt = (x: number, y: number): Grasped | undefined => {
    if (!this.shown) return undefined;
    this.pointed.set((2 * x) / this.width - 1, 1 - (2 * y) / this.height);
    const hit = this.body.hitAt(this.pointed, this.stage.camera);
    if (!hit) return undefined;
    // The top of the body follows the pointer, whichever part was grasped.
    const { size, reach } = this.shown;
    const lever = Math.max(hit.point.length(), (0.8 * size.rim) / reach);
    const pixel = (this.pixel * hit.distance) / lever;
    return { lean: (dx, dy) => this.leanBy(dx * pixel, -dy * pixel) };
  };

  /** Converts a movement to the right and up on the screen into a vector on the table. */
  private leanBy(right: number, up: number): Spot {
    const { azimuth, elevation } = this.view;
    const steep = Math.sin(elevation);
    const away = (up * (Math.sign(steep) || 1)) / Math.max(Math.abs(steep), 0.45);
    const [c, s] = [Math.cos(azimuth), Math.sin(azimuth)];
    return { x: -s * right - c * away, y: c * right - s * away };
  }

  private draw(now: number): void {
    if (this.width < 2 || this.height < 2) return;
    const { body, lab, labels, stage } = this;
    const { camera } = stage;
    // On large screens lines are slightly wider.
    const wider = Math.min(Math.max(Math.min(this.width, this.height) / 600, 1), 2);
    this.pixel = (2 * Math.tan((camera.fov * Math.PI) / 360)) / this.height;
    PIXEL.value = wider * this.pixel;
    const instant = this.instants.now();
    this.frameBody(instant);
    const gliding = this.followBody(instant, now);
    for (const layer of this.layers) layer.update(instant);
    stage.render();
    labels.arrange(camera, this, instant.seeThrough ? undefined : body.outlineIn(camera, this));
    if (gliding) this.changed();
    if (lab.clock.playing.peek() && this.frameRate.isSlow(now) && stage.coarsen()) this.resize();
  }

  /** Frames a body that looks different from the one before. */
  private frameBody(instant: Instant): void {
    const { look, reach, size } = instant;
    if (look !== this.shown?.look) {
      this.view.frame(size.length / reach, size.rim / reach);
      const length = formatLength(cellOf(reach));
      this.frame.scale.textContent = say(words.scene.square, { length });
    }
    this.shown = instant;
  }

  /** Lets the lamp and the camera follow a body that rolls away; returns whether the camera is still moving. */
  private followBody({ contact, pose, reach, size }: Instant, now: number): boolean {
    const { lab, stage, view } = this;
    view.beside = this.ghost.layer?.layOut(size) ?? { x: 0, y: 0 };
    const base = { x: pose.x / reach, y: pose.y / reach };
    view.follow(base.x, base.y);
    view.aim({ x: contact.x / reach, y: contact.y / reach }, base);
    stage.follow(view.focus.x, view.focus.y);
    const gliding = view.update(now);
    lab.azimuth = view.azimuth;
    return gliding;
  }
}
