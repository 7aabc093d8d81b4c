// Labels at spots of the scene. They are HTML elements over the picture, so that they are sharp.

import { type Camera, type Matrix4, Vector3 } from "three";

const MARGIN = 6;
/** Distance between points of the outline on a body as large as the picture, px. */
const BAND = 12;

/** A spot farther from the middle than this, where the edge is 1, is far outside the picture. */
const OUTSIDE = 1.4;

interface Label {
  element: HTMLElement;
  spot: Vector3;
  /** Place on the screen, px from the left and the top. */
  x: number;
  y: number;
  width: number;
  height: number;
  shown: boolean;
  /** Whether the label stays at the edge while its spot is outside. */
  stays: boolean;
}

export class Labels {
  /** Height of a strip at the bottom of the picture that stays free, px. */
  strip = 0;
  private readonly labels: Label[] = [];
  private readonly projected = new Vector3();

  /** Screen readers skip the labels, because the page gives the same information elsewhere. */
  constructor(private readonly place: HTMLElement) {
    place.setAttribute("aria-hidden", "true");
  }

  /** Adds a label. If it `stays`, it is shown at the edge of the picture while its spot is far outside. */
  add(name: string, stays = false): number {
    const element = document.createElement("span");
    element.className = `word ${name}`;
    element.hidden = true;
    this.place.append(element);
    this.labels.push({
      element,
      spot: new Vector3(),
      x: 0,
      y: 0,
      width: 0,
      height: 0,
      shown: false,
      stays,
    });
    return this.labels.length - 1;
  }

  /** Shows a text at a spot of the stage; an empty text hides the label. */
  set(index: number, text: string, x: number, y: number, z = 0): void {
    const label = this.labels[index] as Label;
    label.spot.set(x, y, z);
    label.shown = text !== "";
    label.element.hidden = !label.shown;
    if (!label.shown || label.element.textContent === text) return;
    const { length } = label.element.textContent;
    label.element.textContent = text;
    // Measure the size only when it may have changed, because that costs a layout.
    if (length !== text.length || label.width === 0) label.width = 0;
  }

  /** Dims a label whose spot is hidden. */
  dim(index: number, hidden: boolean): void {
    this.labels[index]?.element.classList.toggle("hidden-spot", hidden);
  }

  /** Places all labels on a picture, earlier ones first, without overlaps and beside a body that
   * would be hidden. */
  arrange(
    camera: Camera,
    { width, height }: Readonly<{ width: number; height: number }>,
    body: Outline | undefined,
  ): void {
    const bottom = height - Math.max(this.strip, MARGIN);
    for (const label of this.labels) {
      if (!label.shown) continue;
      if (label.width === 0) {
        label.width = label.element.offsetWidth;
        label.height = label.element.offsetHeight;
      }
      const { x, y, z } = this.projected.copy(label.spot).project(camera);
      const away = z > 1 || (!label.stays && Math.max(Math.abs(x), Math.abs(y)) > OUTSIDE);
      label.x = ((x + 1) / 2) * width - label.width / 2;
      label.y = ((1 - y) / 2) * height - label.height / 2;
      label.x = Math.min(Math.max(label.x, MARGIN), width - label.width - MARGIN);
      label.y = Math.max(Math.min(label.y, bottom - label.height), MARGIN);
      if (body) keepBeside(label, body, width);
      this.makeRoom(label, bottom);
      label.element.style.visibility = away ? "hidden" : "visible";
      label.element.style.transform = `translate(${label.x.toFixed(1)}px, ${label.y.toFixed(1)}px)`;
    }
  }

  /** Moves a label up or down, past the labels before it, where there is room. */
  private makeRoom(label: Label, bottom: number): void {
    for (const other of this.labels) {
      if (other === label) return;
      if (!other.shown) continue;
      const beside = label.x > other.x + other.width + 4 || other.x > label.x + label.width + 4;
      const gap = (label.height + other.height) / 2 + 3;
      const apart = label.y + label.height / 2 - (other.y + other.height / 2);
      if (beside || Math.abs(apart) >= gap) continue;
      const moved = (by: number) => other.y + other.height / 2 + by - label.height / 2;
      label.y =
        (apart < 0 && moved(-gap) >= MARGIN) || moved(gap) + label.height > bottom
          ? moved(-gap)
          : moved(gap);
    }
  }
}

/** Moves a label that would lie on the body to its nearer side, as far as there is room. */
function keepBeside(label: Label, body: Outline, width: number): void {
  const span = body.between(label.y - BAND, label.y + label.height + BAND);
  if (!span || label.x > span[1] + MARGIN || label.x + label.width < span[0] - MARGIN) return;
  const [left, right] = [span[0] - MARGIN - label.width, span[1] + MARGIN];
  label.x =
    label.x - left < right - label.x
      ? Math.max(left, MARGIN)
      : Math.min(right, width - label.width - MARGIN);
}

// The horizontal extent of the body in the picture, so that labels can be placed beside it.

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
