// The picture of the body on the table and everything drawn round it. It is drawn only when something
// has changed.

import { CylinderGeometry, Group, Matrix4, Mesh, Raycaster, Vector2, Vector3 } from "three";
import {
  bodyAngleAlongContact,
  type Lab,
  type Outcome,
  type Simulated,
  type TurnProgress,
} from "../lab";
import type { Ghost } from "../compare/ghost";
import type { Moment, Motion } from "../core/motion";
import type { InPicture } from "../floor/shaking";
import { formatDegrees } from "../format";
import { inFrame, prefersReducedMotion } from "../timing";
import { BODY_FIELDS } from "../setup/fields";
import type { Held } from "../setup/release";
import type { Setup } from "../setup/setup";
import { dispose, pictureOf, setSeeThrough } from "./bodies/bodies";
import { MARK_FACES, markPlace, reachOf, type Size, sizeOf } from "./bodies/shapes";
import type { Closeup } from "./closeup";
import { Contact, Slip, Trail } from "./path";
import { Dots } from "./dots";
import type { Frame } from "./frame";
import type { Grasped } from "./gestures";
import { formatLength, powerOfTen, Protractor, Ruler } from "./measures";
import { FrameRate, Stage } from "./stage";
import { Guess, type Limit, Wedge } from "./turn";
import { Labels, Outline } from "./labels";
import { readPalette } from "./palette";
import {
  type Footing,
  footingOf,
  heldContact,
  heldPose,
  lowestOf,
  type Pose,
  poseOf,
  type Rim,
  setPose,
  type Spot,
  standingSpot,
} from "./pose";
import { PIXEL } from "./ribbon";
import { Shade } from "./shade";
import type { ShakenTable } from "./shaken";
import { Table } from "./table";
import { View } from "./view";
import { say, words } from "../words/words";

/** How far a shaken table may be from the middle of the picture, in radii of the circle of degrees. */
const LEASH = 0.6;

/** The contact point has begun to run when it has turned by this angle, rad. */
const RUNS = 0.1;
/** Height of the label of the guess above the table, in radii of the circle of degrees. */
const SIGNPOST = 0.24;

const UPRIGHT: Footing = { shift: { x: 0, y: 0 }, slide: 0 };

/** The present place of the body, m. */
interface Placement {
  pose: Pose;
  contact: Spot;
  /** The moment of its motion; undefined while it is held. */
  moment: Moment | undefined;
}

export class Picture {
  readonly view: View;
  private readonly stage: Stage;
  private readonly table = new Table();
  /** Loaded when the floor is first shaken. */
  private shaken: ShakenTable | undefined;
  /** Loaded when it is first looked at. */
  private closeup: Closeup | undefined;
  private closeupWanted = false;
  /** The second motion; loaded when two are first compared. */
  private ghost: Ghost | undefined;
  private ghostWanted = false;
  private readonly protractor = new Protractor();
  private readonly ruler = new Ruler();
  private readonly trail = new Trail();
  private readonly wedge = new Wedge();
  private readonly guess = new Guess();
  private readonly contact = new Contact();
  private readonly slip = new Slip();
  private readonly dots = new Dots();
  private readonly shade = new Shade();
  private readonly labels: Labels;
  private readonly outline = new Outline();
  private readonly labelIds: Record<
    "turned" | "guess" | "theory" | "other" | "itself" | "gap",
    number
  >;
  private palette = readPalette();
  private body = new Group();
  /** A cylinder round the body, for hits of the pointer. */
  private readonly hull = new Mesh(new CylinderGeometry(1, 1, 1, 24).rotateX(Math.PI / 2));
  private size: Size = { rim: 1, widest: 1, length: 1 };
  private rim: Rim = { radius: 1, height: 0 };
  /** Radius of the circle of degrees, m. */
  private reach = 1;
  /** Side of a square of the grid, in radii of the circle of degrees. */
  private cell = 1;
  private readonly frameRate = new FrameRate();
  /** Speed scale √(gR) of the body, m/s. */
  private speed = 1;
  private footing = UPRIGHT;
  private centre: Spot & { of: number } = { x: 0, y: 0, of: NaN };
  private limits: readonly Limit[] = [];
  /** Length of a pixel at distance 1, in units of the stage. */
  private pixel = 0;
  width = 0;
  height = 0;
  /** What was drawn last, to detect changes. */
  private bodyKey = "";
  private followed: Motion | undefined;
  private flicksLaid: unknown;
  private waiting = false;
  private readonly matrix = new Matrix4();
  private readonly caster = new Raycaster();
  private readonly pointed = new Vector2();
  private readonly spot = new Vector3();
  private readonly faces = new Vector3();

  /** Throws if the browser has no WebGL. */
  constructor(
    private readonly lab: Lab,
    private readonly frame: Frame,
  ) {
    this.stage = new Stage(frame.canvas);
    this.setEnvironment();
    this.view = new View(this.stage.camera);
    this.labels = new Labels(frame.words);
    this.labelIds = {
      turned: this.labels.add("turned", true),
      guess: this.labels.add("guess", true),
      theory: this.labels.add("theory"),
      other: this.labels.add("theory"),
      itself: this.labels.add("itself"),
      gap: this.labels.add("gap"),
    };
    this.body.matrixAutoUpdate = this.hull.matrixAutoUpdate = false;
    const { scene } = this.stage;
    scene.add(this.table.mesh, this.shade.mesh, this.protractor.mesh, this.ruler.group);
    scene.add(
      this.wedge.group,
      this.guess.mesh,
      this.trail.mesh,
      this.slip.mesh,
      this.dots.group,
      this.contact.group,
      this.body,
    );
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
    this.setEnvironment();
    this.repaint();
  };

  private setEnvironment(): void {
    const { environment } = this.stage.scene;
    for (const one of [this.table, this.shaken]) one?.setEnvironment(environment);
  }

  /** Applies changed colours. */
  readonly repaint = (): void => {
    this.palette = readPalette();
    this.stage.paint(this.palette);
    this.table.paint(this.palette);
    this.shaken?.paint(this.palette);
    this.closeup?.paint(this.palette);
    this.ghost?.paint(this.palette);
    this.wedge.repaint(this.palette);
    this.slip.paint(this.palette);
    this.shade.paint(this.palette);
    this.followed = this.flicksLaid = undefined;
    this.changed();
  };

  /** The body, if it is at a place of the picture (px). */
  readonly bodyAt = (x: number, y: number): Grasped | undefined => {
    this.pointed.set((2 * x) / this.width - 1, 1 - (2 * y) / this.height);
    this.caster.setFromCamera(this.pointed, this.stage.camera);
    const [hit] = this.caster.intersectObject(this.hull, false);
    if (!hit) return undefined;
    // The top of the body follows the pointer, whichever part was grasped.
    const lever = Math.max(hit.point.length(), (0.8 * this.size.rim) / this.reach);
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
    const { lab } = this;
    const setup = lab.setup.peek();
    this.updateBody(setup);
    this.follow(lab.outcome.peek());
    this.layFlicks(setup);
    const { camera } = this.stage;
    // On large screens lines are slightly wider.
    const wider = Math.min(Math.max(Math.min(this.width, this.height) / 600, 1), 2);
    this.pixel = (2 * Math.tan((camera.fov * Math.PI) / 360)) / this.height;
    PIXEL.value = wider * this.pixel;
    this.view.beside = this.layOutGhost();
    const placement = this.place(lab.held.peek(), setup);
    this.followBody(placement);
    const gliding = this.view.update(now);
    this.moveTable();
    camera.updateMatrixWorld();
    this.mark(placement);
    const progress = lab.held.peek() ? undefined : lab.turnProgress.peek();
    this.showTurn(progress);
    this.showCloseup(placement, progress);
    this.ghost?.show(camera, this.isSeeThrough);
    this.stage.render();
    this.outline.project(this.hull.matrixWorld, camera, this.width, this.height);
    const hides = this.isSeeThrough ? undefined : this.outline;
    this.labels.arrange(camera, this, this.closeup?.unrolled.taken ?? 0, hides);
    if (gliding) this.changed();
    if (lab.clock.playing.peek() && this.frameRate.isSlow(now) && this.stage.coarsen())
      this.resize();
  }

  /** Moves the table in the picture if the floor is shaken. */
  private moveTable(): void {
    const { lab, reach, stage, view } = this;
    lab.azimuth = view.azimuth;
    const place = this.tablePlace();
    this.shaken?.place(place, view.focus, stage.camera, 1 / reach);
  }

  /** Shows the edges of a table that is shaken. */
  private holdTable(simulated: Simulated | undefined): void {
    if (!simulated?.input.shaking) return this.shaken?.hide();
    if (this.shaken) return this.shaken.hold(simulated.motion, 1 / this.reach);
    import("./shaken").then(({ ShakenTable }) => {
      this.shaken ??= new ShakenTable(this.table, this.stage.scene);
      this.shaken.setCell(this.cell);
      this.setEnvironment();
      this.repaint();
    }, console.error);
  }

  private tablePlace(): InPicture {
    const { lab, reach } = this;
    const still = { x: 0, y: 0, z: 0 };
    const held = lab.tableHeld.peek();
    if (held) return { table: held, camera: still };
    const shaking = lab.held.peek() ? undefined : lab.shaking.peek();
    if (!shaking || prefersReducedMotion()) return { table: still, camera: still };
    return shaking.inPicture(lab.clock.time.peek(), LEASH * reach);
  }

  /** Builds the picture of the body again if the body has changed. */
  private updateBody(setup: Readonly<Setup>): void {
    const { body } = setup;
    const key = [
      this.isSeeThrough,
      body,
      ...(BODY_FIELDS[body] ?? []).map((name) => setup[name]),
    ].join(" ");
    if (key === this.bodyKey) return;
    this.bodyKey = key;
    dispose(this.body);
    this.stage.scene.remove(this.body);
    this.body = pictureOf(setup);
    this.body.matrixAutoUpdate = false;
    this.stage.scene.add(this.body);
    setSeeThrough(this.body, this.isSeeThrough);
    this.size = sizeOf(setup);
    this.reach = reachOf(this.size);
    this.view.frame(this.size.length / this.reach, this.size.rim / this.reach);
    const cell = powerOfTen(this.reach / 2.5);
    this.cell = cell / this.reach;
    for (const one of [this.table, this.shaken]) one?.setCell(this.cell);
    this.frame.scale.textContent = say(words.scene.square, { length: formatLength(cell) });
    this.followed = undefined;
  }

  private follow(outcome: Outcome): void {
    this.ruler.measure(this.reach, this.palette);
    const simulated = "motion" in outcome ? outcome : undefined;
    if (simulated && simulated.motion === this.followed) return;
    this.followed = simulated?.motion;
    this.trail.mesh.visible = simulated !== undefined;
    this.centre.of = NaN;
    this.holdTable(simulated);
    if (!simulated) {
      // Without a motion the body is drawn tipped about its rim, for which its height does not matter.
      this.rim = { radius: this.size.rim, height: 0 };
      this.footing = UPRIGHT;
      return;
    }
    const { motion } = simulated;
    const { body, options } = simulated.input;
    this.rim = body;
    this.footing = footingOf(motion, this.rim);
    this.speed = Math.sqrt(options.gravity * this.rim.radius);
    const { shift } = this.footing;
    this.trail.follow(motion, shift, this.reach / 2500, 1 / this.reach, this.palette);
    this.limits = this.limitsHere();
    this.wedge.mark(this.limits, 0.6);
  }

  /** The limiting turn on this table, or those of both ideal laws if it has none. */
  private limitsHere(): Limit[] {
    const theory = this.lab.theory.peek();
    if (!theory) return [];
    const { here, noSlip, frictionless } = theory;
    const { palette } = this;
    if (!Number.isNaN(here))
      return [{ angle: here, color: palette.theory, name: words.scene.theory }];
    return [
      { angle: noSlip, color: palette.rolling, name: words.scene.noSlip },
      { angle: frictionless, color: palette.sliding, name: words.scene.frictionless },
    ].filter(({ angle }) => !Number.isNaN(angle));
  }

  private layFlicks({ yaw }: Readonly<Setup>): void {
    const flicks = this.lab.flicks.peek();
    if (flicks !== this.flicksLaid) {
      this.flicksLaid = flicks;
      const theory = this.lab.theory.peek();
      const limits: Limit[] = theory
        ? [
            { angle: theory.noSlip, color: this.palette.rolling, name: "" },
            { angle: theory.frictionless, color: this.palette.sliding, name: "" },
          ]
        : [];
      this.dots.lay(flicks, (yaw * Math.PI) / 180 + Math.PI, limits, this.palette);
    }
    this.dots.show(this.lab.flicksShown.peek() ?? 0);
  }

  /** Places the body, in the hand or in its motion. */
  private place(held: Held | undefined, setup: Readonly<Setup>): Placement {
    const placement = this.placementAt(held, held ? undefined : this.lab.moment.peek(), setup);
    const { pose } = placement;
    const { rim, reach } = this;
    this.body.matrix.copy(setPose(this.matrix, pose)).premultiply(scaling(1 / reach));
    this.body.matrixWorldNeedsUpdate = true;
    this.placeHull();
    this.shade.show(pose.x / reach, pose.y / reach, rim.radius / reach, pose.tilt);
    return placement;
  }

  private placementAt(
    held: Held | undefined,
    moment: Moment | undefined,
    setup: Readonly<Setup>,
  ): Placement {
    const { rim, footing } = this;
    if (moment) {
      const { x, y } = footing.shift;
      return {
        pose: poseOf(moment, rim.height, footing.shift),
        contact: { x: moment.contact_x + x, y: moment.contact_y + y },
        moment,
      };
    }
    const start = { tilt: (setup.tilt * Math.PI) / 180, yaw: (setup.yaw * Math.PI) / 180 };
    const { tilt, yaw } = held ?? start;
    return {
      pose: heldPose(rim, tilt, yaw, footing.slide),
      contact: heldContact(rim, tilt, yaw, footing.slide),
      moment: undefined,
    };
  }

  /** Lets the lamp, the table and the camera follow a body that rolls away. */
  private followBody({ pose, contact }: Placement): void {
    const { reach } = this;
    this.view.follow(pose.x / reach, pose.y / reach);
    this.view.aim(
      { x: contact.x / reach, y: contact.y / reach },
      { x: pose.x / reach, y: pose.y / reach },
    );
    this.stage.follow(this.view.focus.x, this.view.focus.y);
    this.table.follow(this.view.focus.x, this.view.focus.y);
  }

  /** Shows the contact point and its slip velocity. */
  private mark({ pose, contact, moment }: Placement): void {
    const { palette, reach, stage } = this;
    const { position, quaternion } = stage.camera;
    this.spot.set(contact.x / reach, contact.y / reach, 0);
    this.slip.show(this.spot, moment, this.speed);
    const phases = moment && this.lab.motion.peek()?.phases;
    const kind = phases?.findLast(({ start }) => start <= (moment?.t ?? 0))?.kind;
    const color = kind === "sliding" || kind === "flying" ? palette[kind] : palette.rolling;
    // The contact point is on the near side if the body leans toward the camera.
    const [ex, ey] = [position.x - this.spot.x, position.y - this.spot.y];
    const flat = Math.hypot(ex, ey);
    const toward = (contact.x - pose.x) * ex + (contact.y - pose.y) * ey;
    const before = toward > -0.3 * this.rim.radius * flat && position.z < 3 * flat;
    const near = before || position.z < 0 || this.isSeeThrough;
    this.contact.group.quaternion.copy(quaternion);
    const isLevel = kind === "standing" || kind === "sliding_flat" || kind === "flying_level";
    this.contact.group.visible = !isLevel;
    this.contact.show(this.spot.x, this.spot.y, color, position.distanceTo(this.spot), near);
  }

  private placeHull(): void {
    const { widest, length } = this.size;
    const high = Math.max(length, 0.2 * widest);
    this.hull.matrixWorld
      .copy(this.body.matrix)
      .multiply(this.matrix.makeTranslation(0, 0, high / 2))
      .multiply(this.matrix.makeScale(1.05 * widest, 1.05 * widest, high));
  }

  /** Shows the wedge of the angle of turn, the circle of degrees round it, and their labels. */
  private showTurn(progress: TurnProgress | undefined): void {
    const { lab, labelIds, labels, palette } = this;
    const motion = lab.motion.peek();
    const shown = progress !== undefined && motion !== undefined;
    this.wedge.group.visible = this.trail.mesh.visible = shown;
    const { theory, guess } = lab.marks.peek();
    const comparing = lab.otherSetup.peek() !== undefined;
    this.guess.mesh.visible = shown && guess !== undefined;
    if (!shown) {
      const { yaw } = lab.held.peek() ?? { yaw: (lab.setup.peek().yaw * Math.PI) / 180 };
      this.protractor.lay(0, 0, yaw + Math.PI, true, palette);
      for (const index of Object.values(labelIds)) labels.set(index, "", 0, 0);
      return;
    }
    const before = motion.turns.findLast((turn) => turn.end <= progress.start);
    this.trail.show(lab.clock.time.peek(), progress.start, before?.start ?? 0);
    const { x, y } = this.centreOf(motion, progress);
    const zero = progress.startYaw + Math.PI;
    const sense = Math.sign(progress.turn?.angle ?? progress.angle) || 1;
    this.wedge.show(x, y, zero, progress.angle);
    this.protractor.lay(x, y, zero, sense > 0, palette);
    const label = (index: number, text: string, angle: number, far: number, high = 0) => {
      const [wx, wy] = [x + far * Math.cos(zero + angle), y + far * Math.sin(zero + angle)];
      labels.set(index, text, wx, wy, high);
      labels.dim(index, this.hidden(wx, wy));
    };
    const ranRound = say(words.scene.ranRound, {
      angle: formatDegrees(Math.abs(progress.angle), 1),
    });
    // Before the contact point runs, the visitor who guesses need not know that there is one.
    const early = guess !== undefined && Math.abs(progress.angle) < RUNS;
    const turned = comparing ? say(words.compare.label, { which: "A", text: ranRound }) : ranRound;
    label(labelIds.turned, early ? "" : turned, progress.angle / 2, 1.13);
    // Before a guess is answered, one label is enough.
    if (guess === undefined) this.labelBody(progress);
    else labels.set(labelIds.itself, "", 0, 0);
    // Outside the dots of the flicks, if there are any.
    const far = lab.flicksShown.peek() === undefined ? 1.2 : 1.6;
    const [first, second] = theory ? this.limits : [];
    const limit = (index: number, one: Limit | undefined) =>
      label(
        index,
        one ? `${one.name} ${formatDegrees(one.angle, 1)}` : "",
        sense * (one?.angle ?? 0),
        far,
      );
    limit(labelIds.theory, first);
    limit(labelIds.other, second);
    this.wedge.showLimits(theory);
    if (guess === undefined) return labels.set(labelIds.guess, "", 0, 0);
    this.guess.show(x, y, zero + sense * guess, palette.ink);
    // The label is above the line, as on a signpost.
    label(
      labelIds.guess,
      say(words.scene.guess, { angle: formatDegrees(guess, 0) }),
      sense * guess,
      1.2,
      SIGNPOST,
    );
  }

  /** Shows the rotation of the body itself, at the mark on it. */
  private labelBody(progress: TurnProgress): void {
    const { lab, labelIds, labels, spot } = this;
    const { x, y, z } = spot.copy(markPlace(this.size)).applyMatrix4(this.body.matrix);
    labels.set(
      labelIds.itself,
      say(words.scene.itself, {
        ...words.nouns[lab.setup.peek().body],
        angle: formatDegrees(bodyAngleAlongContact(progress), 1),
      }),
      x,
      y,
      z,
    );
    const away = spot.sub(this.stage.camera.position);
    const faces = this.faces.copy(MARK_FACES).transformDirection(this.body.matrix);
    labels.dim(labelIds.itself, faces.dot(away) > 0);
  }

  /** Whether the body hides a spot of the table. */
  private hidden(x: number, y: number): boolean {
    const { position } = this.stage.camera;
    const { ray } = this.caster;
    ray.origin.copy(position);
    ray.direction.set(x, y, 0).sub(position).normalize();
    return this.caster.intersectObject(this.hull, false).length > 0;
  }

  /** Whether the body is transparent, so that its base and its rim are visible. */
  private get isSeeThrough(): boolean {
    const view = this.lab.view.peek();
    return view === "contact" || view === "below";
  }

  /** Shows the marks on the rim and the magnified gap, if the camera is at the contact point or below. */
  private showCloseup({ pose }: Placement, progress: TurnProgress | undefined): void {
    const { closeup, labels, labelIds, reach, rim, stage } = this;
    const below = stage.camera.position.z < 0;
    this.table.setGlass(below);
    this.ruler.group.visible = !below && !this.isSeeThrough;
    this.shade.mesh.visible = !this.isSeeThrough;
    labels.set(labelIds.gap, "", 0, 0);
    if (!this.isSeeThrough) return closeup?.hide();
    if (!closeup) return this.loadCloseup();
    const near = {
      pose,
      radius: rim.radius,
      minTilt: progress && lowestOf(this.lab.motion.peek(), progress.start, progress.turn)?.tilt,
      placed: this.body.matrix,
      scale: 1 / reach,
    };
    const { text, spot } = closeup.show(near, progress);
    labels.set(labelIds.gap, text, spot.x, spot.y, spot.z);
  }

  /** The place of the second body beside the first, if there is one; it is loaded when it is first needed. */
  private layOutGhost(): Spot {
    const { ghost, lab } = this;
    if (ghost || this.ghostWanted || !lab.otherSetup.peek())
      return ghost?.layOut(this.size) ?? { x: 0, y: 0 };
    this.ghostWanted = true;
    import("../compare/ghost").then(
      ({ Ghost }) => {
        this.ghost = new Ghost(lab, this.labels);
        this.ghost.paint(this.palette);
        this.stage.scene.add(this.ghost.group);
        this.changed();
      },
      (error: unknown) => {
        this.ghostWanted = false;
        console.error(error);
      },
    );
    return { x: 0, y: 0 };
  }

  private loadCloseup(): void {
    if (this.closeupWanted) return;
    this.closeupWanted = true;
    import("./closeup").then(
      ({ Closeup }) => {
        this.closeup = new Closeup(this.lab, this.frame.stage);
        this.closeup.paint(this.palette);
        this.stage.scene.add(this.closeup.group);
        this.changed();
      },
      (error: unknown) => {
        this.closeupWanted = false;
        console.error(error);
      },
    );
  }

  /** The centre of the base at the smallest tilt of this turn, about which the contact point runs. */
  private centreOf(motion: Motion, progress: TurnProgress): Spot {
    const { centre, rim, reach, footing } = this;
    const { start } = progress;
    if (centre.of === start) return centre;
    const flat = standingSpot(motion, progress, rim, footing);
    this.centre = { x: flat.x / reach, y: flat.y / reach, of: start };
    return this.centre;
  }
}

const scale = new Matrix4();
const scaling = (factor: number) => scale.makeScale(factor, factor, factor);
