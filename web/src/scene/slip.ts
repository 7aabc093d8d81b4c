// The slip velocity, as an arrow from the contact point.

import type { Moment } from "../core/motion";
import type { Palette } from "./palette";
import type { Spot } from "./pose";
import { Ribbon } from "./ribbon";

/** Length of the arrow at a speed of √(gR) and its largest length, in radii of the circle of degrees. */
const [LENGTH, LONGEST] = [0.5, 0.75];
/** Smallest speed with an arrow, over √(gR). */
const SLOWEST = 0.01;

export class Slip {
  private readonly ribbon = new Ribbon(3.2);
  private color = "";

  get mesh() {
    return this.ribbon.mesh;
  }

  constructor() {
    this.mesh.position.z = 0.003;
    this.mesh.renderOrder = -1;
  }

  paint({ sliding }: Palette): void {
    this.color = sliding;
  }

  /** Draws the arrow from a spot of the stage; `unit` is √(gR), m/s. */
  show({ x, y }: Spot, moment: Moment | undefined, unit: number): void {
    const [vx, vy] = [moment?.slip_x ?? 0, moment?.slip_y ?? 0];
    const speed = Math.hypot(vx, vy) / unit;
    this.mesh.visible = speed > SLOWEST;
    if (!this.mesh.visible) return;
    const length = Math.min(LENGTH * speed, LONGEST);
    const [ex, ey] = [(vx / unit / speed) * length, (vy / unit / speed) * length];
    const to = [x + ex, y + ey] as const;
    const barb = (side: number) =>
      [to[0] - 0.22 * ex - side * 0.12 * ey, to[1] - 0.22 * ey + side * 0.12 * ex] as const;
    const { color } = this;
    this.ribbon.layStrokes([
      { from: [x, y], to, color },
      { from: to, to: barb(1), color },
      { from: to, to: barb(-1), color },
    ]);
  }
}
