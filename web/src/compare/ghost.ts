// The second motion in the picture: a see-through body at the place of the first, or an opaque one beside it, with a
// dashed path, a hollow contact point and a dashed line to where it has run.

import {
  CircleGeometry,
  Color,
  Group,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  type MeshStandardMaterial,
  RingGeometry,
  Vector3,
} from "three";
import type { Motion } from "../core/motion";
import { formatDegrees, formatNumber } from "../format";
import type { Lab, TurnProgress } from "../lab";
import { BODY_FIELDS } from "../setup/fields";
import type { Setup } from "../setup/setup";
import { dispose, pictureOf } from "../scene/bodies/bodies";
import { reachOf, type Size, sizeOf } from "../scene/bodies/shapes";
import type { Labels } from "../scene/labels";
import type { Palette } from "../scene/palette";
import { type Footing, footingOf, poseOf, type Rim, setPose, standingSpot } from "../scene/pose";
import { PIXEL, Ribbon, type Stroke } from "../scene/ribbon";
import { Shade } from "../scene/body";
import type { Instant, Layer } from "../scene/instant";
import { say, words } from "../words/words";

/** Opacity of a ghost, and the part of its colour that is not the body's own. */
const [OPACITY, TINT] = [0.42, 0.45];
/** Length of a dash, radius of the arc, and largest number of dashes, in radii of the circle of degrees. */
const [DASH, ARC, MOST] = [0.035, 0.91, 3000];
/** Points of a ribbon for each stroke; those with a width are the third and the fourth. */
const PER_STROKE = 6;

export class Ghost implements Layer {
  readonly group = new Group();
  private readonly trail = new Ribbon(3);
  private readonly turn = new Ribbon(2.6);
  private readonly shade = new Shade();
  private readonly dot = new Group();
  private readonly ring = new MeshBasicMaterial({
    toneMapped: false,
    transparent: true,
    depthTest: false,
  });
  private body = new Group();
  private bodyKey = "";
  private size: Size = { rim: 1, widest: 1, length: 1 };
  private layout: Layout = { offset: { x: 0, y: 0 }, reach: 1, times: 1 };
  private followed: { motion: Motion; rim: Rim; footing: Footing } | undefined;
  private dashes: Dash[] = [];
  private colour = "#000000";
  private readonly labelIds: { turned: number; named: number };
  private readonly matrix = new Matrix4();
  private readonly spot = new Vector3();

  constructor(
    private readonly lab: Lab,
    private readonly labels: Labels,
  ) {
    this.labelIds = { turned: labels.add("ghost", true), named: labels.add("ghost", true) };
    const paper = new MeshBasicMaterial({ toneMapped: false, transparent: true, depthTest: false });
    const disk = (mesh: Mesh, order: number) => {
      mesh.renderOrder = order;
      this.dot.add(mesh);
    };
    // Radii in pixels. The middle is white, unlike that of the first motion.
    disk(new Mesh(new CircleGeometry(6.5, 32), paper), 4);
    disk(new Mesh(new RingGeometry(3.6, 6.5, 32), this.ring), 5);
    this.trail.mesh.position.z = 0.0024;
    this.turn.mesh.position.z = 0.0018;
    this.trail.mesh.renderOrder = this.turn.mesh.renderOrder = -2;
    this.group.add(this.trail.mesh, this.turn.mesh, this.shade.mesh, this.dot, this.body);
    this.group.visible = false;
  }

  paint(palette: Palette): void {
    this.colour = palette.ghost;
    this.ring.color.set(palette.ghost);
    this.shade.paint(palette);
    this.bodyKey = "";
    this.followed = undefined;
  }

  /** Decides where B is drawn beside a body A; returns its distance from A. */
  layOut(a: Size): { x: number; y: number } {
    const setup = this.lab.otherSetup.peek();
    if (!setup) return { x: 0, y: 0 };
    this.size = sizeOf(setup);
    this.layout = layoutOf(a, this.size);
    return this.layout.offset;
  }

  /** Shows B at the time shown. If A is transparent, a second such body would confuse. */
  update({ camera, seeThrough }: Instant): void {
    const { lab, labels, labelIds } = this;
    const setup = lab.otherSetup.peek();
    const outcome = lab.other.outcome.peek();
    const moment = lab.otherMoment.peek();
    const simulated = outcome && "motion" in outcome ? outcome : undefined;
    this.group.visible =
      setup !== undefined && simulated !== undefined && moment !== undefined && !lab.held.peek();
    if (!this.group.visible || !setup || !simulated || !moment) {
      for (const index of Object.values(labelIds)) labels.set(index, "", 0, 0);
      return;
    }
    const { offset, reach } = this.layout;
    this.group.position.set(offset.x, offset.y, 0);
    this.updateBody(setup);
    const { rim, footing } = this.follow(simulated.motion, simulated.input.body);
    const pose = poseOf(moment, rim.height, footing.shift);
    this.body.matrix.copy(setPose(this.matrix, pose)).premultiply(scaling(1 / reach));
    this.body.matrixWorldNeedsUpdate = true;
    const beside = isBeside(this.layout);
    this.body.visible = beside || !seeThrough;
    this.shade.mesh.visible = beside;
    this.shade.show(pose.x / reach, pose.y / reach, rim.radius / reach, pose.tilt);
    const contact = {
      x: (moment.contact_x + footing.shift.x) / reach,
      y: (moment.contact_y + footing.shift.y) / reach,
    };
    this.dot.quaternion.copy(camera.quaternion);
    this.dot.position.set(contact.x, contact.y, 0.004);
    this.spot.set(contact.x + offset.x, contact.y + offset.y, 0);
    this.dot.scale.setScalar(PIXEL.value * camera.position.distanceTo(this.spot));
    const progress = lab.otherProgress.peek();
    const before = simulated.motion.turns.findLast(({ end }) => end <= (progress?.start ?? 0));
    this.trail.show(
      this.placeAt(moment.t),
      this.placeAt(progress?.start ?? 0) - 0.5,
      this.placeAt(before?.start ?? 0) - 0.5,
    );
    this.showTurn(simulated.motion, progress);
    this.name(setup, beside);
  }

  /** The rim and the footing of a motion, whose path is laid out when it is new. */
  private follow(motion: Motion, rim: Rim): { rim: Rim; footing: Footing } {
    if (this.followed?.motion === motion) return this.followed;
    const footing = footingOf(motion, rim);
    this.followed = { motion, rim, footing };
    const { reach } = this.layout;
    const curve = motion.curve();
    const placed = (name: "contact_x" | "contact_y", shift: number) =>
      curve.column(name).map((value) => (value + shift) / reach);
    const [x, y] = [placed("contact_x", footing.shift.x), placed("contact_y", footing.shift.y)];
    this.dashes = dashesAlong(curve.column("t"), x, y, DASH, MOST);
    this.trail.layStrokes(this.dashes.map(({ from, to }) => ({ from, to, color: this.colour })));
    return this.followed;
  }

  /** The place of a time (s) on the path, in points of its ribbon. */
  private placeAt(time: number): number {
    const begun = dashesUntil(this.dashes, time);
    const whole = Math.floor(begun);
    return PER_STROKE * whole + (begun > whole ? 2 + begun - whole : 0);
  }

  private updateBody(setup: Readonly<Setup>): void {
    const beside = isBeside(this.layout);
    const numbers = (BODY_FIELDS[setup.body] ?? []).map((name) => setup[name]);
    const key = [setup.body, beside, this.layout.reach, ...numbers].join(" ");
    if (key === this.bodyKey) return;
    this.bodyKey = key;
    this.followed = undefined;
    dispose(this.body);
    this.group.remove(this.body);
    this.body = pictureOf(setup);
    this.body.matrixAutoUpdate = false;
    if (!beside) makeGhostly(this.body, new Color(this.colour));
    this.group.add(this.body);
  }

  /** Shows the angle of turn as a dashed arc from the initial direction, and a line to its end. */
  private showTurn(motion: Motion, progress: TurnProgress | undefined): void {
    const { labels, labelIds, followed, layout, colour } = this;
    this.turn.mesh.visible = progress !== undefined;
    if (!progress || !followed) return labels.set(labelIds.turned, "", 0, 0);
    const centre = standingSpot(motion, progress, followed.rim, followed.footing);
    const [x, y] = [centre.x / layout.reach, centre.y / layout.reach];
    const zero = progress.startYaw + Math.PI;
    const spot = (angle: number, far: number) =>
      [x + far * Math.cos(zero + angle), y + far * Math.sin(zero + angle)] as const;
    const pieces = Math.max(Math.ceil((Math.abs(progress.angle) * ARC) / DASH), 1);
    const strokes: Stroke[] = [];
    for (let k = 0; k < pieces; k += 2) {
      const [from, to] = [k, k + 1].map((n) => (progress.angle * n) / pieces) as [number, number];
      strokes.push({ from: spot(from, ARC), to: spot(to, ARC), color: colour });
    }
    for (let far = 0; far < ARC; far += 2 * DASH) {
      const out = Math.min(far + DASH, ARC);
      strokes.push({
        from: spot(progress.angle, far),
        to: spot(progress.angle, out),
        color: colour,
      });
    }
    this.turn.layStrokes(strokes);
    const [wx, wy] = spot(progress.angle, 1.02);
    const angle = formatDegrees(Math.abs(progress.angle), 1);
    labels.set(
      labelIds.turned,
      say(words.compare.label, { which: "B", text: say(words.scene.ranRound, { angle }) }),
      wx + layout.offset.x,
      wy + layout.offset.y,
    );
  }

  /** Names a body that stands beside A, at its top. */
  private name(setup: Readonly<Setup>, beside: boolean): void {
    const { labels, labelIds, layout, size, spot } = this;
    if (!beside) return labels.set(labelIds.named, "", 0, 0);
    const times = formatNumber(layout.times, 2);
    spot.set(0, 0, size.length).applyMatrix4(this.body.matrix);
    labels.set(
      labelIds.named,
      say(words.compare.label, {
        which: "B",
        text: say(words.compare.drawn, { ...words.nouns[setup.body], times }),
      }),
      spot.x + layout.offset.x,
      spot.y + layout.offset.y,
      spot.z,
    );
  }
}

/** Makes a body see-through, with a tint. Where it coincides with another body, the other one is seen. */
function makeGhostly(body: Group, tint: Color): void {
  body.traverse((part) => {
    part.castShadow = part.receiveShadow = false;
    if (!(part instanceof Mesh)) return;
    const look = part.material as MeshStandardMaterial;
    look.color.lerp(tint, TINT);
    Object.assign(look, {
      transparent: true,
      opacity: OPACITY,
      depthWrite: false,
      metalness: 0,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 2,
      needsUpdate: true,
    });
  });
}

const scale = new Matrix4();
const scaling = (factor: number) => scale.makeScale(factor, factor, factor);

// Where the second body is drawn.

/** Bodies whose sizes differ by more than this factor stand side by side: the smaller one would vanish inside the
 * larger one. */
const ALIKE = 1.5;
/** Distance between bodies side by side, in radii of the circle of degrees; the two circles do not meet. */
const APART = 2.3;
/** To the right in the initial view. */
const RIGHT = [0.978, 0.209] as const;

export interface Layout {
  /** Place of B on the table, in radii of the circle of degrees of A. */
  offset: { x: number; y: number };
  /** Length that is drawn as long as the radius of the circle of degrees, m. */
  reach: number;
  /** How many times larger than A it is drawn. */
  times: number;
}

/** A ghost at the place of A and to its scale if the bodies are about as large, else beside it and as large. */
export function layoutOf(a: Size, b: Size): Layout {
  const [mine, other] = [reachOf(a), reachOf(b)];
  const ratio = mine / other;
  if (Math.max(ratio, 1 / ratio) <= ALIKE) return { offset: { x: 0, y: 0 }, reach: mine, times: 1 };
  return { offset: { x: APART * RIGHT[0], y: APART * RIGHT[1] }, reach: other, times: ratio };
}

export const isBeside = ({ offset }: Layout): boolean => offset.x !== 0 || offset.y !== 0;

// A path as dashes of equal length, each with the times of its ends.

export interface Dash {
  from: readonly [x: number, y: number];
  to: readonly [x: number, y: number];
  start: number;
  end: number;
}

/** Dashes along a path through points at increasing times. They are `length` long with gaps as long between them, or
 * longer if there would be more than `most`. */
export function dashesAlong(
  t: ArrayLike<number>,
  x: ArrayLike<number>,
  y: ArrayLike<number>,
  length: number,
  most: number,
): Dash[] {
  const along = new Float64Array(t.length);
  for (let k = 1; k < t.length; k++)
    along[k] = along[k - 1]! + Math.hypot(x[k]! - x[k - 1]!, y[k]! - y[k - 1]!);
  const whole = along[along.length - 1] ?? 0;
  const step = Math.max(length, whole / (2 * most));
  if (!(whole > 0) || !(step > 0)) return [];
  let k = 0;
  const at = (place: number) => {
    while (k < along.length - 2 && along[k + 1]! < place) k++;
    const width = along[k + 1]! - along[k]!;
    const part = width > 0 ? Math.min((place - along[k]!) / width, 1) : 0;
    const between = (of: ArrayLike<number>) => of[k]! + part * (of[k + 1]! - of[k]!);
    return { t: between(t), spot: [between(x), between(y)] as const };
  };
  const dashes: Dash[] = [];
  for (let n = 0; 2 * n * step < whole; n++) {
    const from = at(2 * n * step);
    const to = at(Math.min((2 * n + 1) * step, whole));
    dashes.push({ from: from.spot, to: to.spot, start: from.t, end: to.t });
  }
  return dashes;
}

/** How many dashes have begun at a time, the last one counted by its part. */
export function dashesUntil(dashes: readonly Dash[], time: number): number {
  let [low, high] = [0, dashes.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (dashes[middle]!.start <= time) low = middle + 1;
    else high = middle;
  }
  const last = dashes[low - 1];
  if (!last) return 0;
  const width = last.end - last.start;
  return low - 1 + (width > 0 ? Math.min((time - last.start) / width, 1) : 1);
}
