// A ruler on the table, with a scale that suits the body.

import { BoxGeometry, Group, Mesh, MeshStandardMaterial } from "three";
import { FlatDrawing } from "./flat";
import { roundLength, unitOf } from "./lengths";
import type { Palette } from "./palette";
import { formatNumber } from "../format/numbers";

/** Size of the ruler, in radii of the circle of degrees. */
const [LENGTH, WIDTH, THICK] = [2.3, 0.17, 0.016];

export class Ruler {
  readonly group = new Group();
  private readonly drawing = new FlatDrawing(LENGTH, WIDTH, 2048);
  private readonly material = new MeshStandardMaterial({ roughness: 0.55 });
  private lastLook = "";

  constructor() {
    const block = new Mesh(new BoxGeometry(LENGTH, WIDTH, THICK), this.material);
    block.position.z = THICK / 2;
    block.castShadow = block.receiveShadow = true;
    this.drawing.mesh.position.z = THICK + 0.001;
    this.drawing.mesh.renderOrder = -5;
    this.group.add(block, this.drawing.mesh);
    this.group.position.set(0, -1.27, 0);
  }

  /** `reach` is the radius of the circle of degrees, m. */
  measure(reach: number, palette: Palette): void {
    this.material.color.set(palette.dark ? "#b08a52" : "#f3d9a4");
    const look = `${reach} ${palette.dark}`;
    if (look === this.lastLook) return;
    this.lastLook = look;
    this.drawing.draw((pen, pixels) => ticks(pen, pixels, reach * LENGTH));
  }
}

/** `length` is that of the whole ruler, m. */
function ticks(pen: CanvasRenderingContext2D, pixels: number, length: number): void {
  const metre = pixels / length;
  const height = (pixels * WIDTH) / LENGTH;
  const step = roundLength(length / 9);
  const fine = step / (String(step).includes("2") ? 4 : 10);
  const margin = 0.018 * pixels;
  const count = Math.floor((length - (2 * margin) / metre) / step);
  const unit = unitOf(step);
  pen.fillStyle = "#2b2014";
  const first = -pixels / 2 + (pixels - count * step * metre) / 2;
  const each = Math.round(step / fine);
  for (let k = 0; k <= count * each; k++) {
    const long = k % each === 0 ? 0.46 : (2 * k) % each === 0 ? 0.34 : 0.22;
    const wide = k % each === 0 ? 3.2 : 2;
    const x = first + (k * step * metre) / each;
    pen.fillRect(x - wide / 2, -height / 2, wide, long * height);
  }
  pen.font = `600 ${0.36 * height}px system-ui, sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  const text = (k: number) => formatNumber((k * step) / unit.size);
  // Every long mark has a number, or every second, third … one if there is no room.
  const apart = Math.ceil(pen.measureText(`${text(count)}  `).width / (step * metre));
  for (let k = 0; k <= count; k += apart)
    pen.fillText(text(k), first + k * step * metre, 0.22 * height);
  pen.font = `400 ${0.26 * height}px system-ui, sans-serif`;
  pen.fillText(unit.name, first + 0.45 * step * metre, 0.24 * height);
}
