// Detects a machine that draws frames too slowly.

/** Number of frames over which the rate is averaged. */
const WINDOW = 24;
/** Longest average time of a frame that looks smooth, ms. */
const SLOW = 28;
/** After a longer interval than this, ms, nothing was drawn in between. */
const REST = 400;

export class FrameRate {
  private before = 0;
  private count = 0;
  private sum = 0;

  /** Registers a frame at a time, ms; returns true after WINDOW frames that were slow on average. */
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
