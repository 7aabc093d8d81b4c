// The prints on the bodies. Each print shows the orientation of the body.

import { CanvasTexture, SRGBColorSpace } from "three";

type Pen = CanvasRenderingContext2D;

const FACE = '"Avenir Next", "Segoe UI", system-ui, sans-serif';

function printed(width: number, height: number, draw: (pen: Pen) => void): CanvasTexture {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  draw(canvas.getContext("2d") as Pen);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 8;
  return texture;
}

function box(pen: Pen, color: string, x: number, y: number, width: number, height: number) {
  pen.fillStyle = color;
  pen.fillRect(x, y, width, height);
}

function words(pen: Pen, text: string, x: number, y: number, size: number, weight = 800) {
  pen.font = `${weight} ${size}px ${FACE}`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillText(text, x, y);
}

function disk(pen: Pen, color: string, x: number, y: number, radius: number) {
  pen.fillStyle = color;
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fill();
}

/** The label of a tin. One lozenge has a different colour from all others. */
export const tinLabel = () =>
  printed(2048, 768, (pen) => {
    box(pen, "#f6efdf", 0, 0, 2048, 768);
    box(pen, "#16455f", 0, 0, 2048, 150);
    box(pen, "#16455f", 0, 618, 2048, 150);
    box(pen, "#e0a526", 0, 150, 2048, 14);
    box(pen, "#e0a526", 0, 604, 2048, 14);
    for (let k = 0; k < 16; k++) {
      for (const y of [75, 693]) {
        pen.fillStyle = k === 4 ? "#e4572e" : k % 4 === 0 ? "#e0a526" : "#f6efdf";
        lozenge(pen, 128 * k + 64, y, 46, 54);
      }
    }
    for (const middle of [512, 1536]) {
      pen.fillStyle = "#16455f";
      words(pen, "rock", middle, 296, 176);
      words(pen, "& roll", middle, 462, 176);
    }
    for (const [middle, color] of [
      [0, "#e4572e"],
      [1024, "#2f8f6b"],
      [2048, "#e4572e"],
    ] as const) {
      disk(pen, color, middle, 384, 168);
      disk(pen, "#f6efdf", middle, 384, 142);
      disk(pen, color, middle, 384, 130);
      pen.strokeStyle = "#f6efdf";
      pen.lineWidth = 20;
      pen.lineCap = "round";
      pen.beginPath();
      pen.arc(middle, 384, 72, 0.4, 2 * Math.PI - 0.5);
      pen.stroke();
      pen.fillStyle = "#f6efdf";
      lozenge(pen, middle + 66, 344, 34, 34);
    }
  });

function lozenge(pen: Pen, x: number, y: number, width: number, height: number) {
  pen.beginPath();
  pen.moveTo(x, y - height);
  pen.lineTo(x + width, y);
  pen.lineTo(x, y + height);
  pen.lineTo(x - width, y);
  pen.fill();
}

export const sodaPrint = () =>
  printed(2048, 1024, (pen) => {
    const ground = pen.createLinearGradient(0, 0, 0, 1024);
    ground.addColorStop(0, "#0b6fa8");
    ground.addColorStop(1, "#07476f");
    pen.fillStyle = ground;
    pen.fillRect(0, 0, 2048, 1024);
    for (const [color, lift, height] of [
      ["#f4f7f8", 0, 150],
      ["#e4572e", 110, 120],
      ["#f2b632", 190, 60],
    ] as const) {
      pen.fillStyle = color;
      pen.beginPath();
      for (let x = 0; x <= 2048; x += 16)
        pen.lineTo(x, 640 + lift - 90 * Math.sin((x / 2048) * 4 * Math.PI));
      for (let x = 2048; x >= 0; x -= 16)
        pen.lineTo(x, 640 + lift + height - 90 * Math.sin((x / 2048) * 4 * Math.PI));
      pen.fill();
    }
    pen.fillStyle = "#f4f7f8";
    for (const middle of [512, 1536]) {
      pen.save();
      pen.translate(middle, 330);
      pen.rotate(-0.12);
      words(pen, "WOBBLE", 0, 0, 190, 900);
      pen.restore();
    }
    for (const [x, y, size] of [
      [120, 250, 46],
      [60, 400, 26],
      [190, 430, 18],
      [210, 150, 22],
    ] as const)
      disk(pen, "#f2b632", x, y, size);
  });

export const beerLabel = () =>
  printed(2048, 640, (pen) => {
    box(pen, "#f3e9d2", 0, 0, 2048, 640);
    box(pen, "#7c2d12", 0, 0, 2048, 40);
    box(pen, "#7c2d12", 0, 600, 2048, 40);
    for (const [middle, color] of [
      [512, "#7c2d12"],
      [1536, "#1f4d3a"],
    ] as const) {
      disk(pen, color, middle, 320, 232);
      disk(pen, "#f3e9d2", middle, 320, 216);
      disk(pen, color, middle, 320, 204);
      pen.fillStyle = "#f3e9d2";
      words(pen, "42", middle, 290, 190, 900);
      words(pen, "FLICKS", middle, 410, 64, 700);
    }
    pen.fillStyle = "#7c2d12";
    for (const middle of [0, 1024, 2048]) words(pen, "LAGER", middle, 320, 120, 900);
  });

export const batteryPrint = () =>
  printed(1024, 1024, (pen) => {
    box(pen, "#22262a", 0, 0, 1024, 1024);
    box(pen, "#c8773a", 0, 0, 1024, 270);
    box(pen, "#e9c49a", 0, 262, 1024, 16);
    for (const [middle, mark] of [
      [256, "#e9c49a"],
      [768, "#56b4e9"],
    ] as const) {
      pen.save();
      pen.translate(middle, 610);
      pen.rotate(-Math.PI / 2);
      pen.fillStyle = "#f4f4f2";
      words(pen, "AA", -150, 0, 190, 900);
      pen.fillStyle = mark;
      words(pen, "1.5 V", 150, 0, 120, 600);
      pen.restore();
      pen.fillStyle = "#22262a";
      words(pen, "+", middle, 140, 230, 900);
    }
  });

/** The face of a coin, seen from above; its edge touches the edge of the square. */
export const coinFace = () =>
  printed(1024, 1024, (pen) => {
    disk(pen, "#d9b45a", 512, 512, 512);
    disk(pen, "#a8842f", 512, 512, 378);
    disk(pen, "#dcdcd6", 512, 512, 370);
    for (let k = 0; k < 12; k++) {
      const angle = (k * Math.PI) / 6;
      pen.fillStyle = "#8c6a1d";
      star(pen, 512 + 442 * Math.cos(angle), 512 + 442 * Math.sin(angle), 36, angle);
    }
    pen.fillStyle = "#8f8f88";
    words(pen, "1", 396, 530, 470, 800);
    words(pen, "ROLL", 640, 470, 96, 800);
    words(pen, "2007", 640, 580, 80, 600);
    pen.fillStyle = "#c4c4bc";
    words(pen, "1", 390, 522, 470, 800);
  });

function star(pen: Pen, x: number, y: number, size: number, turned: number) {
  pen.beginPath();
  for (let k = 0; k < 10; k++) {
    const angle = turned + (k * Math.PI) / 5;
    const far = k % 2 ? 0.42 * size : size;
    pen.lineTo(x + far * Math.cos(angle), y + far * Math.sin(angle));
  }
  pen.fill();
}

/** The face of the toy, with coloured rays like its foils. */
export const diskFace = () =>
  printed(1024, 1024, (pen) => {
    disk(pen, "#cfd6db", 512, 512, 512);
    const colors = ["#0072b2", "#56b4e9", "#009e73", "#f0e442", "#e69f00", "#d55e00", "#cc79a7"];
    for (let k = 0; k < 28; k++) {
      const angle = (k * Math.PI) / 14;
      pen.fillStyle = colors[k % 7] as string;
      pen.globalAlpha = k % 2 ? 0.9 : 0.55;
      pen.beginPath();
      pen.moveTo(512, 512);
      pen.arc(512, 512, 400, angle, angle + Math.PI / 14);
      pen.fill();
    }
    pen.globalAlpha = 1;
    disk(pen, "#e9edf0", 512, 512, 130);
    disk(pen, "#d55e00", 512 + 455, 512, 34);
  });

/** A row of fields round the edge of a ring. */
export const ringPrint = () =>
  printed(1024, 32, (pen) => {
    box(pen, "#c9a14a", 0, 0, 1024, 32);
    for (let k = 0; k < 8; k++) box(pen, "#7a5a1c", 128 * k, 0, 10, 32);
    box(pen, "#d55e00", 0, 0, 128, 32);
    box(pen, "#0072b2", 512, 0, 128, 32);
  });
