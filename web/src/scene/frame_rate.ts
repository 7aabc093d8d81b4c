// Whether the machine keeps up with the pictures.

/** Pictures over which it is judged. */
const WINDOW = 24;
/** ms: slower than this, on average, is not smooth. */
const SLOW = 28;
/** ms: longer than this nothing was to be drawn in between. */
const REST = 400;

export class FrameRate {
  private before = 0;
  private count = 0;
  private sum = 0;

  /** Takes note of a picture drawn at a time, ms; true each time that many in a row were slow. */
  isSlow(now: number): boolean {
    const passed = now - this.before;
    this.before = now;
    if (passed > REST) {
      this.count = this.sum = 0;
      return false;
    }
    this.sum += passed;
    if (++this.count < WINDOW) return false;
    const slow = this.sum / this.count > SLOW;
    this.count = this.sum = 0;
    return slow;
  }
}
