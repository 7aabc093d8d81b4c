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
} from "three";
import type { Palette } from "./palette";
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

export class Wedge {
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

export class Guess {
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
