// The turn on the table: the angle so far, the limits of theory, and a visitor's guess.

import {
  BufferGeometry,
  Color,
  DoubleSide,
  DynamicDrawUsage,
  Float32BufferAttribute,
  Group,
  Mesh,
  MeshBasicMaterial,
  Vector3,
} from "three";
import type { Theory } from "../core/core";
import type { Motion } from "../core/motion";
import { formatDegrees } from "../format";
import { bodyAngleAlongContact, type TurnProgress } from "../lab";
import { say, words } from "../words/words";
import { MARK_FACES, markPlace } from "./bodies/shapes";
import type { BodyLayer } from "./body";
import type { Instant, Layer } from "./instant";
import type { Labels } from "./labels";
import { Protractor } from "./measures";
import type { Palette } from "./palette";
import { type Spot, standingSpot } from "./pose";
import { Ribbon, type Stroke } from "./ribbon";

const PIECES = 180;
/** Radius of the sector, in radii of the circle of degrees. */
const SIZE = 0.82;
/** Each further revolution lies further out by this much. */
const SPIRAL = 0.035;

/** A limiting turn, rad, and its colour. */
export interface Limit {
  angle: number;
  color: string;
  /** Label beside the line. */
  name: string;
}

/** The contact point has begun to run when it has turned by this angle, rad. */
const RUNS = 0.1;
/** Height of the label of the guess above the table, in radii of the circle of degrees. */
const SIGNPOST = 0.24;

export class TurnLayer implements Layer {
  readonly group = new Group();
  private readonly protractor = new Protractor();
  private readonly wedge = new Wedge();
  private readonly guess = new Guess();
  private readonly ids: Record<"turned" | "guess" | "theory" | "other" | "itself", number>;
  private palette: Palette | undefined;
  private limits: readonly Limit[] = [];
  private followed: Motion | undefined;
  /** The middle of the turn that starts at a time (s), on the stage. */
  private centre: Spot & { of: number } = { x: 0, y: 0, of: NaN };
  private readonly spot = new Vector3();
  private readonly faces = new Vector3();

  constructor(
    private readonly labels: Labels,
    private readonly body: BodyLayer,
  ) {
    this.ids = {
      turned: labels.add("turned", true),
      guess: labels.add("guess", true),
      theory: labels.add("theory"),
      other: labels.add("theory"),
      itself: labels.add("itself"),
    };
    this.group.add(this.protractor.mesh, this.wedge.group, this.guess.mesh);
  }

  paint(palette: Palette): void {
    this.palette = palette;
    this.wedge.repaint(palette);
    this.followed = undefined;
  }

  update(instant: Instant): void {
    const { progress, simulated } = instant;
    const { palette } = this;
    if (!palette) return;
    if (simulated && simulated.motion !== this.followed) {
      this.followed = simulated.motion;
      this.centre.of = NaN;
      this.limits = limitsOf(simulated.theory, palette);
      this.wedge.mark(this.limits, 0.6);
    }
    const { guess } = instant.lab.marks.peek();
    this.wedge.group.visible = progress !== undefined && simulated !== undefined;
    this.guess.mesh.visible = this.wedge.group.visible && guess !== undefined;
    if (progress && simulated) this.show(instant, simulated.motion, progress, palette);
    else this.clear(instant, palette);
  }

  /** Only the circle of degrees remains. */
  private clear({ lab, setup }: Instant, palette: Palette): void {
    const { yaw } = lab.held.peek() ?? { yaw: (setup.yaw * Math.PI) / 180 };
    this.protractor.lay(0, 0, yaw + Math.PI, true, palette);
    for (const index of Object.values(this.ids)) this.labels.set(index, "", 0, 0);
  }

  private show(instant: Instant, motion: Motion, progress: TurnProgress, palette: Palette): void {
    const { ids, labels } = this;
    const { guess, theory } = instant.lab.marks.peek();
    const { x, y } = this.centreOf(instant, motion, progress);
    const zero = progress.startYaw + Math.PI;
    const sense = Math.sign(progress.turn?.angle ?? progress.angle) || 1;
    this.wedge.show(x, y, zero, progress.angle);
    this.protractor.lay(x, y, zero, sense > 0, palette);
    const label = (index: number, text: string, angle: number, far: number, high = 0) => {
      const [wx, wy] = [x + far * Math.cos(zero + angle), y + far * Math.sin(zero + angle)];
      labels.set(index, text, wx, wy, high);
      labels.dim(index, this.body.hides(wx, wy, instant.camera));
    };
    label(ids.turned, turnedInWords(instant, progress), progress.angle / 2, 1.13);
    this.labelBody(instant, progress);
    // Outside the dots of the flicks, if there are any.
    const far = instant.lab.flicksShown.peek() === undefined ? 1.2 : 1.6;
    const [first, second] = theory ? this.limits : [];
    const limit = (index: number, one: Limit | undefined) =>
      label(
        index,
        one ? `${one.name} ${formatDegrees(one.angle, 1)}` : "",
        sense * (one?.angle ?? 0),
        far,
      );
    limit(ids.theory, first);
    limit(ids.other, second);
    this.wedge.showLimits(theory);
    if (guess === undefined) return labels.set(ids.guess, "", 0, 0);
    this.guess.show(x, y, zero + sense * guess, palette.ink);
    // The label is above the line, as on a signpost.
    const text = say(words.scene.guess, { angle: formatDegrees(guess, 0) });
    label(ids.guess, text, sense * guess, 1.2, SIGNPOST);
  }

  /** Shows the rotation of the body itself, at the mark on it. Before a guess is answered, one label is enough. */
  private labelBody({ camera, lab, placed, setup, size }: Instant, progress: TurnProgress): void {
    const { ids, labels, spot } = this;
    if (lab.marks.peek().guess !== undefined) return labels.set(ids.itself, "", 0, 0);
    const { x, y, z } = spot.copy(markPlace(size)).applyMatrix4(placed);
    const angle = formatDegrees(bodyAngleAlongContact(progress), 1);
    labels.set(ids.itself, say(words.scene.itself, { ...words.nouns[setup.body], angle }), x, y, z);
    const away = spot.sub(camera.position);
    const faces = this.faces.copy(MARK_FACES).transformDirection(placed);
    labels.dim(ids.itself, faces.dot(away) > 0);
  }

  /** The centre of the base at the smallest tilt of this turn, about which the contact point runs. */
  private centreOf({ footing, reach, rim }: Instant, motion: Motion, progress: TurnProgress): Spot {
    const { start } = progress;
    if (this.centre.of === start) return this.centre;
    const flat = standingSpot(motion, progress, rim, footing);
    this.centre = { x: flat.x / reach, y: flat.y / reach, of: start };
    return this.centre;
  }
}

function turnedInWords({ lab }: Instant, { angle }: TurnProgress): string {
  // Before the contact point runs, the visitor who guesses need not know that there is one.
  if (lab.marks.peek().guess !== undefined && Math.abs(angle) < RUNS) return "";
  const text = say(words.scene.ranRound, { angle: formatDegrees(Math.abs(angle), 1) });
  const comparing = lab.otherSetup.peek() !== undefined;
  return comparing ? say(words.compare.label, { which: "A", text }) : text;
}

/** The limiting turn on this table, or those of both ideal laws if it has none. */
function limitsOf({ here, noSlip, frictionless }: Theory, palette: Palette): Limit[] {
  if (!Number.isNaN(here))
    return [{ angle: here, color: palette.theory, name: words.scene.theory }];
  return [
    { angle: noSlip, color: palette.rolling, name: words.scene.noSlip },
    { angle: frictionless, color: palette.sliding, name: words.scene.frictionless },
  ].filter(({ angle }) => !Number.isNaN(angle));
}

class Wedge {
  readonly group = new Group();
  private readonly fill: Mesh<BufferGeometry, MeshBasicMaterial>;
  private readonly edge = new Ribbon(3);
  private readonly limits = new Ribbon(3);
  private marked = false;
  private readonly paint = new Color();
  private readonly x = new Float64Array(PIECES + 3);
  private readonly y = new Float64Array(PIECES + 3);

  constructor() {
    const positions = new Float32BufferAttribute(3 * (PIECES + 2), 3).setUsage(DynamicDrawUsage);
    const index = Array.from({ length: PIECES }, (_, k) => [0, k + 1, k + 2]).flat();
    this.fill = new Mesh(
      new BufferGeometry().setAttribute("position", positions).setIndex(index),
      new MeshBasicMaterial({
        transparent: true,
        opacity: 0.3,
        depthWrite: false,
        side: DoubleSide,
        toneMapped: false,
      }),
    );
    this.fill.frustumCulled = false;
    this.fill.renderOrder = -5;
    this.edge.mesh.renderOrder = -4;
    this.limits.mesh.renderOrder = -3;
    this.group.add(this.fill, this.edge.mesh, this.limits.mesh);
    this.group.position.z = 0.0014;
  }

  repaint({ wedge, dark }: Palette): void {
    this.paint.set(wedge);
    this.fill.material.color.set(wedge);
    this.fill.material.opacity = dark ? 0.3 : 0.34;
  }

  /** Shows a sector round a spot, from an azimuth through an angle, rad. */
  show(x: number, y: number, from: number, angle: number): void {
    this.group.position.set(x, y, this.group.position.z);
    this.group.rotation.z = from;
    const positions = this.fill.geometry.getAttribute("position") as Float32BufferAttribute;
    const filled = Math.min(Math.abs(angle), 2 * Math.PI) * Math.sign(angle);
    for (let k = 0; k <= PIECES; k++) {
      const part = (filled * k) / PIECES;
      positions.setXYZ(k + 1, SIZE * Math.cos(part), SIZE * Math.sin(part), 0);
    }
    positions.needsUpdate = true;
    // The edge runs out along the initial direction, round, and back to the middle.
    const [sx, sy] = [this.x, this.y];
    sx[0] = sy[0] = 0;
    for (let k = 0; k <= PIECES; k++) {
      const part = (angle * k) / PIECES;
      const size = SIZE + SPIRAL * Math.max(Math.abs(part) / (2 * Math.PI) - 1, 0);
      sx[k + 1] = size * Math.cos(part);
      sy[k + 1] = size * Math.sin(part);
    }
    sx[PIECES + 2] = sy[PIECES + 2] = 0;
    this.edge.lay(PIECES + 3, sx, sy, () => this.paint);
  }

  /** Draws the limits to both sides, from an inner radius outward. */
  mark(limits: readonly Limit[], inner: number): void {
    this.marked = limits.length > 0;
    this.limits.layStrokes(limitStrokes(limits, inner, 1.07));
  }

  /** Shows or hides the marked limits. */
  showLimits(shown: boolean): void {
    this.limits.mesh.visible = shown && this.marked;
  }
}

/** Lines at limiting turns to both sides, between two radii. */
export const limitStrokes = (limits: readonly Limit[], inner: number, outer: number): Stroke[] =>
  limits.flatMap(({ angle, color }) =>
    [angle, -angle].map((way) => ({
      from: [inner * Math.cos(way), inner * Math.sin(way)] as const,
      to: [outer * Math.cos(way), outer * Math.sin(way)] as const,
      color,
    })),
  );

// A visitor's guess of where the body comes up: a line on the table.

class Guess {
  private readonly line = new Ribbon(5);
  readonly mesh = this.line.mesh;

  constructor() {
    this.mesh.position.z = 0.0016;
    this.mesh.renderOrder = -3;
  }

  /** Shows a guess at an azimuth (rad) round a spot of the table. */
  show(x: number, y: number, azimuth: number, color: string): void {
    const [c, s] = [Math.cos(azimuth), Math.sin(azimuth)];
    this.line.layStrokes([{ from: [x, y], to: [x + 1.25 * c, y + 1.25 * s], color }]);
  }
}
