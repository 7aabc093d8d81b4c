// The horizontal extent of the body in the picture, so that labels can be placed beside it.

import { type Camera, type Matrix4, Vector3 } from "three";

const [ROUND, HIGH] = [24, 9];

/** Points on the surface of a cylinder with radius 1 and height 1 about the origin. */
const SURFACE: readonly Vector3[] = Array.from({ length: ROUND * HIGH }, (_, k) => {
  const [angle, row] = [(2 * Math.PI * (k % ROUND)) / ROUND, Math.floor(k / ROUND)];
  return new Vector3(Math.cos(angle), Math.sin(angle), row / (HIGH - 1) - 0.5);
});

export class Outline {
  private readonly x = new Float64Array(SURFACE.length);
  private readonly y = new Float64Array(SURFACE.length);
  private readonly projected = new Vector3();

  /** Projects the cylinder, placed by a matrix, into a camera's picture with a size in px. */
  project(placed: Matrix4, camera: Camera, width: number, height: number): void {
    SURFACE.forEach((point, k) => {
      const { x, y } = this.projected.copy(point).applyMatrix4(placed).project(camera);
      this.x[k] = ((x + 1) / 2) * width;
      this.y[k] = ((1 - y) / 2) * height;
    });
  }

  /** The extent between two heights of the picture, px; undefined if the body is not there. */
  between(top: number, bottom: number): [left: number, right: number] | undefined {
    let [left, right] = [Infinity, -Infinity];
    this.x.forEach((x, k) => {
      const y = this.y[k] as number;
      if (y < top || y > bottom) return;
      left = Math.min(left, x);
      right = Math.max(right, x);
    });
    return left < right ? [left, right] : undefined;
  }
}
