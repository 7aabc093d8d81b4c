// Canvas drawings that lie flat on the table.

import {
  CanvasTexture,
  DoubleSide,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  SRGBColorSpace,
} from "three";

/** A drawing on a plane, redrawn when its content changes. */
export class FlatDrawing {
  readonly mesh: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly canvas = document.createElement("canvas");
  private readonly texture: CanvasTexture;

  constructor(width: number, height: number, pixels: number) {
    this.canvas.width = pixels;
    this.canvas.height = Math.round((pixels * height) / width);
    this.texture = new CanvasTexture(this.canvas);
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.anisotropy = 16;
    const material = new MeshBasicMaterial({
      map: this.texture,
      transparent: true,
      depthWrite: false,
      toneMapped: false,
      side: DoubleSide,
    });
    this.mesh = new Mesh(new PlaneGeometry(width, height), material);
  }

  /** Draws with a pen whose unit is a pixel, whose origin is the middle and whose y axis points down. */
  draw(paint: (pen: CanvasRenderingContext2D, pixels: number) => void): void {
    const pen = this.canvas.getContext("2d") as CanvasRenderingContext2D;
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.translate(this.canvas.width / 2, this.canvas.height / 2);
    paint(pen, this.canvas.width);
    this.texture.needsUpdate = true;
  }
}
