// A visitor's guess of where the body comes up: a line on the table.

import { Ribbon } from "./ribbon";

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
