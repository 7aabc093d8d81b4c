// What measures on the table: the circle of degrees, a ruler, and lengths as the picture writes them.

import type { Palette } from "./palette";
import {
  BoxGeometry,
  CanvasTexture,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PlaneGeometry,
  SRGBColorSpace,
} from "three";
import { formatLengthShort, formatNumber, significant } from "../format";

const SIZE = 2.2;

export class Protractor {
  private readonly drawing = new FlatDrawing(SIZE, SIZE, devicePixelRatio > 1.2 ? 4096 : 2048);
  private lastLook = "";

  get mesh() {
    return this.drawing.mesh;
  }

  constructor() {
    this.mesh.renderOrder = -6;
    this.mesh.position.z = 0.0006;
  }

  /** Places the circle round a spot, with 0 toward an azimuth (rad), counted anticlockwise or clockwise. */
  lay(x: number, y: number, zero: number, anticlockwise: boolean, palette: Palette): void {
    this.mesh.position.set(x, y, this.mesh.position.z);
    this.mesh.rotation.z = zero;
    const look = `${anticlockwise} ${palette.ink}`;
    if (look === this.lastLook) return;
    this.lastLook = look;
    this.drawing.draw((pen, pixels) => scale(pen, pixels / SIZE, anticlockwise, palette));
  }
}

/** `radius` is that of the circle, in pixels; 0 is toward +x, and y points down. */
function scale(
  pen: CanvasRenderingContext2D,
  radius: number,
  anticlockwise: boolean,
  palette: Palette,
): void {
  pen.strokeStyle = pen.fillStyle = palette.ink;
  pen.globalAlpha = 0.05;
  pen.lineWidth = 0.13 * radius;
  circle(pen, radius * 0.935);
  pen.globalAlpha = 0.55;
  pen.lineWidth = 0.004 * radius;
  circle(pen, radius);
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  for (let degrees = 0; degrees < 360; degrees++) {
    const angle = ((anticlockwise ? -1 : 1) * degrees * Math.PI) / 180;
    const [length, alpha] =
      degrees % 10 === 0 ? [0.055, 0.8] : degrees % 5 === 0 ? [0.036, 0.6] : [0.02, 0.4];
    pen.globalAlpha = alpha;
    pen.lineWidth = (degrees % 10 === 0 ? 0.0055 : 0.0032) * radius;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    pen.beginPath();
    pen.moveTo(radius * c, radius * s);
    pen.lineTo((1 - length) * radius * c, (1 - length) * radius * s);
    pen.stroke();
    if (degrees % 30 === 0) number(pen, degrees, angle, radius);
  }
}

function circle(pen: CanvasRenderingContext2D, radius: number): void {
  pen.beginPath();
  pen.arc(0, 0, radius, 0, 2 * Math.PI);
  pen.stroke();
}

/** Draws a number with its foot outward, so that the numbers near the viewer are upright. */
function number(pen: CanvasRenderingContext2D, degrees: number, angle: number, radius: number) {
  pen.save();
  pen.rotate(angle);
  pen.translate(0.9 * radius, 0);
  pen.rotate(-Math.PI / 2);
  pen.font = `600 ${0.062 * radius}px system-ui, sans-serif`;
  pen.globalAlpha = 0.85;
  pen.fillText(`${degrees}°`, 0.01 * radius, 0);
  pen.restore();
}

// A ruler on the table, with a scale that suits the body.

/** Size of the ruler, in radii of the circle of degrees. */
const [LENGTH, WIDTH, THICK] = [2.3, 0.17, 0.016];

export class Ruler {
  readonly group = new Group();
  private readonly drawing = new FlatDrawing(LENGTH, WIDTH, 2048);
  private readonly material = new MeshStandardMaterial({ roughness: 0.55 });
  private reach = NaN;

  constructor() {
    const block = new Mesh(new BoxGeometry(LENGTH, WIDTH, THICK), this.material);
    block.position.z = THICK / 2;
    block.castShadow = block.receiveShadow = true;
    this.drawing.mesh.position.z = THICK + 0.001;
    this.drawing.mesh.renderOrder = -5;
    this.group.add(block, this.drawing.mesh);
    this.group.position.set(0, -1.27, 0);
  }

  paint({ dark }: Palette): void {
    this.material.color.set(dark ? "#b08a52" : "#f3d9a4");
  }

  /** `reach` is the radius of the circle of degrees, m. */
  measure(reach: number): void {
    if (reach === this.reach) return;
    this.reach = reach;
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

// Lengths as the picture writes them.

/** The largest of 1, 2 and 5 times a power of ten that does not exceed a length, m. */
export function roundLength(max: number): number {
  const ten = 10 ** Math.floor(Math.log10(max) + 1e-9);
  const times = max / ten;
  return ten * (times >= 5 ? 5 : times >= 2 ? 2 : 1);
}

/** The largest power of ten that does not exceed a length, m. */
export const powerOfTen = (max: number) => 10 ** Math.floor(Math.log10(max) + 1e-9);

/** The unit that suits a length, m. */
export function unitOf(length: number): { name: string; size: number } {
  if (length < 0.0099) return { name: "mm", size: 0.001 };
  if (length < 0.99) return { name: "cm", size: 0.01 };
  return { name: "m", size: 1 };
}

/** A length (m) of any size, with two or three digits. */
export function formatSmall(length: number): string {
  if (length === 0) return "0\u00a0cm";
  // Tens of centimetres have a decimal, like millimetres.
  return length >= 0.1 && length < 1
    ? `${significant(100 * length, 3)}\u00a0cm`
    : formatLengthShort(length);
}

export function formatLength(length: number): string {
  const { name, size } = unitOf(length);
  return `${formatNumber(length / size)} ${name}`;
}

// Canvas drawings that lie flat on the table.

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
