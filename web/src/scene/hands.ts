// A hand that tips the body and lets it go, at rest or, to flick it, in motion.

import type { Lab } from "../lab";
import { type Lean, ZERO_RATE, leanFields, releasedSetup } from "../setup/release";
import type { Setup } from "../setup/setup";

const DEGREES = 180 / Math.PI;
/** Bounds of the tilt of a held body, rad. */
const [MIN_TILT, MAX_TILT] = [0.5 / DEGREES, 89 / DEGREES];
/** The rate of the hand is averaged over this time, ms. */
const RECENT = 80;

export class Hands {
  private lean: Lean = { x: 0, y: 0 };
  private readonly recent: { x: number; y: number; when: number }[] = [];

  constructor(private readonly lab: Lab) {}

  get holding(): boolean {
    return this.lab.held.peek() !== undefined;
  }

  /** Grasps the body as it stands now. */
  take(): void {
    const { tilt, yaw } = this.lab.moment.peek() ?? start(this.lab.setup.peek());
    this.lab.clock.pause();
    this.recent.length = 0;
    // The body leans toward its contact point, opposite to its yaw.
    this.hold({ x: -tilt * Math.cos(yaw), y: -tilt * Math.sin(yaw) });
  }

  /** Changes the lean by a vector on the table, rad. */
  push(x: number, y: number): void {
    this.hold({ x: this.lean.x + x, y: this.lean.y + y });
  }

  /** Changes the tilt, rad, in the direction of the lean. */
  tip(by: number): void {
    const tilt = Math.hypot(this.lean.x, this.lean.y);
    const times = Math.min(Math.max(tilt + by, MIN_TILT), MAX_TILT) / tilt;
    this.hold({ x: this.lean.x * times, y: this.lean.y * times });
  }

  /** Swings the lean round by an angle, rad. */
  swing(by: number): void {
    const [c, s] = [Math.cos(by), Math.sin(by)];
    const { x, y } = this.lean;
    this.hold({ x: c * x - s * y, y: s * x + c * y });
  }

  /** Puts the body back as it was. */
  cancel(): void {
    this.lab.held.value = undefined;
  }

  /** Lets go, with the rate of the hand unless `moving` is false. */
  release(moving = true): void {
    const held = this.lab.held.peek();
    if (!held) return;
    const rate = moving ? this.rate() : ZERO_RATE;
    this.letGo(releasedSetup(held, rate, this.lab.setup.peek()));
  }

  /** Lets go with the rates of the set-up, for keys, which have no rate of their own. */
  flick(): void {
    const held = this.lab.held.peek();
    if (held) this.letGo(leanFields(held));
  }

  private letGo(part: Partial<Setup>): void {
    this.lab.change({ ...part, start: "tilted" });
    this.lab.held.value = undefined;
    // Restart even if the release is the same as before.
    this.lab.clock.rewind();
    this.lab.whenComplete(() => this.lab.clock.play());
  }

  private hold(lean: Lean): void {
    const tilt = Math.hypot(lean.x, lean.y);
    const held = Math.min(Math.max(tilt, MIN_TILT), MAX_TILT);
    const direction = tilt > 1e-9 ? Math.atan2(lean.y, lean.x) : Math.PI;
    this.lean = { x: held * Math.cos(direction), y: held * Math.sin(direction) };
    this.lab.held.value = { tilt: held, yaw: direction + Math.PI };
    const when = performance.now();
    this.recent.push({ ...lean, when });
    while (this.recent.length > 2 && when - (this.recent[0]?.when ?? when) > RECENT)
      this.recent.shift();
  }

  /** The recent rate of change of the lean, rad/s. */
  private rate(): Lean {
    const now = performance.now();
    const recent = this.recent.filter(({ when }) => now - when <= RECENT);
    const [first, last] = [recent[0], recent[recent.length - 1]];
    // The time counts up to now and not to the last movement, so that a stopped hand is at rest.
    const passed = first ? (now - first.when) / 1000 : 0;
    if (!first || !last || passed < 0.008) return ZERO_RATE;
    return { x: (last.x - first.x) / passed, y: (last.y - first.y) / passed };
  }
}

function start({ tilt, yaw }: Readonly<Setup>): { tilt: number; yaw: number } {
  return { tilt: tilt / DEGREES, yaw: yaw / DEGREES };
}
