// A hand on the body: tipping it, letting it go at rest, or flicking it by letting go in motion.

import type { Lab } from "../lab";
import { type Lean, ZERO_RATE, leanFields, releasedSetup } from "../setup/release";
import type { Setup } from "../setup/setup";

const DEGREES = 180 / Math.PI;
/** What a hand can hold, rad. */
const [LEAST, MOST] = [0.5 / DEGREES, 89 / DEGREES];
/** The motion of the hand is that of its last moments, ms. */
const RECENT = 80;

export class Hands {
  private lean: Lean = { x: 0, y: 0 };
  private readonly recent: { x: number; y: number; when: number }[] = [];

  constructor(private readonly lab: Lab) {}

  get holding(): boolean {
    return this.lab.held.peek() !== undefined;
  }

  /** Takes the body as it stands now. */
  take(): void {
    const { tilt, yaw } = this.lab.moment.peek() ?? start(this.lab.setup.peek());
    this.lab.clock.pause();
    this.recent.length = 0;
    // It leans toward the point at which it touches the table, opposite to its yaw.
    this.hold({ x: -tilt * Math.cos(yaw), y: -tilt * Math.sin(yaw) });
  }

  /** Leans it further by an arrow on the table, rad. */
  push(x: number, y: number): void {
    this.hold({ x: this.lean.x + x, y: this.lean.y + y });
  }

  /** Tips it further, or less far, the way it leans, rad. */
  tip(by: number): void {
    const tilt = Math.hypot(this.lean.x, this.lean.y);
    const times = Math.min(Math.max(tilt + by, LEAST), MOST) / tilt;
    this.hold({ x: this.lean.x * times, y: this.lean.y * times });
  }

  /** Leads the lean round, rad. */
  round(by: number): void {
    const [c, s] = [Math.cos(by), Math.sin(by)];
    const { x, y } = this.lean;
    this.hold({ x: c * x - s * y, y: s * x + c * y });
  }

  /** Puts it back as it was. */
  cancel(): void {
    this.lab.held.value = undefined;
  }

  /** Lets go, with the motion of the hand if it is in motion. */
  release(moving = true): void {
    const held = this.lab.held.peek();
    if (!held) return;
    const rate = moving ? this.rate() : ZERO_RATE;
    this.letGo(releasedSetup(held, rate, this.lab.setup.peek()));
  }

  /** Lets go with the rates that are set, as keys do not move like a hand. */
  flick(): void {
    const held = this.lab.held.peek();
    if (held) this.letGo(leanFields(held));
  }

  private letGo(part: Partial<Setup>): void {
    this.lab.change(part);
    this.lab.held.value = undefined;
    // Not while it is watched.
    this.lab.complete();
    // Also when it is let go just as it was before.
    this.lab.clock.rewind();
    this.lab.clock.play();
  }

  private hold(lean: Lean): void {
    const tilt = Math.hypot(lean.x, lean.y);
    const kept = Math.min(Math.max(tilt, LEAST), MOST);
    const way = tilt > 1e-9 ? Math.atan2(lean.y, lean.x) : Math.PI;
    this.lean = { x: kept * Math.cos(way), y: kept * Math.sin(way) };
    this.lab.held.value = { tilt: kept, yaw: way + Math.PI };
    const when = performance.now();
    this.recent.push({ ...lean, when });
    while (this.recent.length > 2 && when - (this.recent[0]?.when ?? when) > RECENT)
      this.recent.shift();
  }

  /** How fast the hand has led the lean recent, rad/s. */
  private rate(): Lean {
    const now = performance.now();
    const recent = this.recent.filter(({ when }) => now - when <= RECENT);
    const [first, last] = [recent[0], recent[recent.length - 1]];
    // Up to now, not to its last move: a hand that has stopped is at rest.
    const passed = first ? (now - first.when) / 1000 : 0;
    if (!first || !last || passed < 0.008) return ZERO_RATE;
    return { x: (last.x - first.x) / passed, y: (last.y - first.y) / passed };
  }
}

function start({ tilt, yaw }: Readonly<Setup>): { tilt: number; yaw: number } {
  return { tilt: tilt / DEGREES, yaw: yaw / DEGREES };
}
