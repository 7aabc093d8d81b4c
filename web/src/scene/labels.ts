// Labels at places of the scene: elements of the page laid over the picture, so that they are crisp.

import { type Camera, Vector3 } from "three";
import type { Outline } from "./outline";

const MARGIN = 6;
/** As far as points of the outline are apart on a body as large as the picture, px. */
const BAND = 12;

/** Farther from the middle than this, its edge being 1, a spot is far outside the picture. */
const OUTSIDE = 1.4;

interface Label {
  element: HTMLElement;
  spot: Vector3;
  /** Where it goes on the screen, px from the left and the top; negative infinity when unseen. */
  x: number;
  y: number;
  width: number;
  height: number;
  shown: boolean;
  /** Whether it is seen at the edge while its spot is beyond. */
  stays: boolean;
}

export class Labels {
  private readonly words: Label[] = [];
  private readonly seen = new Vector3();

  /** The picture says in other ways too what these words say, so they are not read out. */
  constructor(private readonly place: HTMLElement) {
    place.setAttribute("aria-hidden", "true");
  }

  /** One that `stays` is said at the edge of the picture while its spot is far outside. */
  add(name: string, stays = false): number {
    const element = document.createElement("span");
    element.className = `word ${name}`;
    element.hidden = true;
    this.place.append(element);
    this.words.push({
      element,
      spot: new Vector3(),
      x: 0,
      y: 0,
      width: 0,
      height: 0,
      shown: false,
      stays,
    });
    return this.words.length - 1;
  }

  /** Says a text at a spot of the stage; nothing for an empty one. */
  say(index: number, text: string, x: number, y: number, z = 0): void {
    const word = this.words[index] as Label;
    word.spot.set(x, y, z);
    word.shown = text !== "";
    word.element.hidden = !word.shown;
    if (!word.shown || word.element.textContent === text) return;
    const { length } = word.element.textContent;
    word.element.textContent = text;
    // Measured only when it may have changed: measuring costs a layout.
    if (length !== text.length || word.width === 0) word.width = 0;
  }

  /** Pales a word whose spot is hidden. */
  dim(index: number, hidden: boolean): void {
    this.words[index]?.element.classList.toggle("hidden-spot", hidden);
  }

  /** Puts all of them in their places, first come first served, none over another nor over the body. */
  arrange(camera: Camera, width: number, height: number, body: Outline): void {
    for (const word of this.words) {
      if (!word.shown) continue;
      if (word.width === 0) {
        word.width = word.element.offsetWidth;
        word.height = word.element.offsetHeight;
      }
      const { x, y, z } = this.seen.copy(word.spot).project(camera);
      const away = z > 1 || (!word.stays && Math.max(Math.abs(x), Math.abs(y)) > OUTSIDE);
      word.x = ((x + 1) / 2) * width - word.width / 2;
      word.y = ((1 - y) / 2) * height - word.height / 2;
      word.x = Math.min(Math.max(word.x, MARGIN), width - word.width - MARGIN);
      word.y = Math.min(Math.max(word.y, MARGIN), height - word.height - MARGIN);
      keepBeside(word, body, width);
      this.makeRoom(word);
      word.element.style.visibility = away ? "hidden" : "visible";
      word.element.style.transform = `translate(${word.x.toFixed(1)}px, ${word.y.toFixed(1)}px)`;
    }
  }

  /** Simulated a word up or down, past the words before it. */
  private makeRoom(word: Label): void {
    for (const other of this.words) {
      if (other === word) return;
      if (!other.shown) continue;
      const beside =
        word.x > other.x + other.width + 4 || other.x > word.x + word.width + 4 ? true : false;
      const gap = (word.height + other.height) / 2 + 3;
      const apart = word.y + word.height / 2 - (other.y + other.height / 2);
      if (beside || Math.abs(apart) >= gap) continue;
      word.y = other.y + other.height / 2 + (apart < 0 ? -gap : gap) - word.height / 2;
    }
  }
}

/** Simulated a word aside that would lie on the body, the shorter way, as far as there is room. */
function keepBeside(word: Label, body: Outline, width: number): void {
  const span = body.between(word.y - BAND, word.y + word.height + BAND);
  if (!span || word.x > span[1] + MARGIN || word.x + word.width < span[0] - MARGIN) return;
  const [left, right] = [span[0] - MARGIN - word.width, span[1] + MARGIN];
  word.x =
    word.x - left < right - word.x
      ? Math.max(left, MARGIN)
      : Math.min(right, width - word.width - MARGIN);
}
