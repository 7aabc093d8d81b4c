// The circle of degrees on the table, counted from the initial lean in the direction of the turn.

import type { Palette } from "./palette";
import { FlatDrawing } from "./flat";

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
