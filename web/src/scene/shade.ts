// The ambient shadow close under the body.

import { CanvasTexture, Mesh, MeshBasicMaterial, PlaneGeometry } from "three";
import type { Palette } from "./palette";

export class Shade {
  readonly mesh: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private darkest = 0.5;

  constructor() {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 128;
    const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
    const fade = pen.createRadialGradient(64, 64, 0, 64, 64, 64);
    for (const [at, alpha] of [
      [0, 1],
      [0.6, 0.9],
      [0.72, 0.5],
      [0.85, 0.16],
      [1, 0],
    ] as const)
      fade.addColorStop(at, `rgb(0 0 0 / ${alpha})`);
    pen.fillStyle = fade;
    pen.fillRect(0, 0, 128, 128);
    const material = new MeshBasicMaterial({
      map: new CanvasTexture(canvas),
      color: "#000000",
      transparent: true,
      depthWrite: false,
    });
    this.mesh = new Mesh(new PlaneGeometry(2.8, 2.8), material);
    this.mesh.position.z = 0.0003;
    this.mesh.renderOrder = -8;
  }

  paint({ dark }: Palette): void {
    this.darkest = dark ? 0.6 : 0.42;
  }

  /** Shows the shadow under a base with a radius; it is paler at larger tilts. */
  show(x: number, y: number, radius: number, tilt: number): void {
    this.mesh.position.set(x, y, this.mesh.position.z);
    this.mesh.scale.setScalar(radius);
    this.mesh.material.opacity =
      this.darkest * (1 - 0.75 * Math.min(Math.abs(Math.sin(tilt)) * 2, 1));
  }
}
