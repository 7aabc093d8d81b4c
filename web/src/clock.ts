// The time at which a motion is shown. A near-collision lasts microseconds, so time can stretch
// automatically while the contact point races: a schedule maps the visitor's time to the motion's time
// and limits how fast the contact point runs on the screen. Two motions that are compared share one schedule.

import { computed, type ReadonlySignal, type Signal, signal } from "@preact/signals-core";
import type { Motion } from "./core/motion";
import { INITIAL_PLAYBACK } from "./setup/playback";

/** Largest speed of the contact point in stretched time, rad per second of the visitor. */
export const MAX_CONTACT_RATE = 2.5;

/** Maps the visitor's time to the motion's time; both increase from knot to knot. */
class Schedule {
  constructor(
    /** s of the motion */
    private readonly times: Float64Array,
    /** s of the visitor at speed 1 */
    private readonly shown: Float64Array,
  ) {}

  static of(motion: Motion, stretched: boolean): Schedule {
    const { t, yaw } = motion.yaws();
    const shown = new Float64Array(t.length);
    for (let k = 1; k < t.length; k++) {
      const [dt, turned] = [at(t, k) - at(t, k - 1), Math.abs(at(yaw, k) - at(yaw, k - 1))];
      // At an instant the contact point may jump, where the base comes down flat or lifts off.
      const slow = stretched && dt > 0;
      shown[k] = at(shown, k - 1) + (slow ? Math.max(dt, turned / MAX_CONTACT_RATE) : dt);
    }
    return new Schedule(t, shown);
  }

  /** A schedule for two motions: at each time, that of the one that is shown more slowly. */
  static ofBoth(a: Schedule, b: Schedule): Schedule {
    const times = Float64Array.from([...a.times, ...b.times]).sort();
    const shown = new Float64Array(times.length);
    const [slowA, slowB] = [a.slownesses(), b.slownesses()];
    for (let k = 1; k < times.length; k++) {
      const [from, to] = [at(times, k - 1), at(times, k)];
      const dt = to - from;
      const slow = dt > 0 ? Math.max(slowA(from, to), slowB(from, to)) : 0;
      shown[k] = at(shown, k - 1) + dt * slow;
    }
    return new Schedule(times, shown);
  }

  /** Gives the visitor's seconds per second of the motion between two times that have no knot between them, for
   * times that increase from call to call. After the end of the motion time is not stretched. */
  private slownesses(): (from: number, to: number) => number {
    const { times, shown } = this;
    let low = 0;
    return (from, to) => {
      while (low < times.length - 2 && at(times, low + 1) <= from) low++;
      const width = at(times, low + 1) - at(times, low);
      const inside = at(times, low) <= from && at(times, low + 1) >= to;
      return inside && width > 0 ? (at(shown, low + 1) - at(shown, low)) / width : 1;
    };
  }

  get length(): number {
    return this.shown[this.shown.length - 1] ?? 0;
  }

  timeAt(shown: number): number {
    return interpolated(this.shown, this.times, shown);
  }

  shownAt(time: number): number {
    return interpolated(this.times, this.shown, time);
  }

  /** Visitor's seconds per second of the motion, between the two knots around a time (s). */
  slowdownAt(time: number): number {
    const { length } = this.times;
    let low = knotBefore(this.times, time);
    // Several knots may be at one time; skip them forward, or backward at the end.
    while (low < length - 2 && at(this.times, low + 1) === at(this.times, low)) low++;
    while (low > 0 && at(this.times, low + 1) === at(this.times, low)) low--;
    const interval = at(this.times, low + 1) - at(this.times, low);
    return interval > 0 ? (at(this.shown, low + 1) - at(this.shown, low)) / interval : 1;
  }
}

export class Clock {
  readonly playing: Signal<boolean> = signal(false);
  /** Seconds of the motion per second of the visitor, before the stretching. */
  readonly speed: Signal<number> = signal(INITIAL_PLAYBACK.speed);
  /** Whether time stretches automatically while the contact point races. */
  readonly stretched: Signal<boolean> = signal(INITIAL_PLAYBACK.stretched);
  /** s of the motion */
  readonly time: Signal<number> = signal(0);
  /** Time at which playing stops, s of the motion. */
  private until = Infinity;
  private readonly schedule: ReadonlySignal<Schedule | undefined>;

  /** `other` is a second motion that is shown at the same time. */
  constructor(
    private readonly motion: ReadonlySignal<Motion | undefined>,
    private readonly other: ReadonlySignal<Motion | undefined> = signal(undefined),
  ) {
    const scheduleOf = (motion: ReadonlySignal<Motion | undefined>) =>
      computed(() => motion.value && Schedule.of(motion.value, this.stretched.value));
    const [mine, others] = [scheduleOf(motion), scheduleOf(other)];
    this.schedule = computed(() =>
      mine.value && others.value ? Schedule.ofBoth(mine.value, others.value) : mine.value,
    );
  }

  /** End of the longer motion, s. */
  get end(): number {
    const { motion, other } = this;
    return motion.value ? Math.max(motion.value.end, other.value?.end ?? 0) : 0;
  }

  /** Fraction of the showing time that has passed, 0 to 1; set it to scrub. */
  get progress(): number {
    return this.progressAt(this.time.value);
  }

  set progress(part: number) {
    const schedule = this.schedule.value;
    if (schedule) this.time.value = schedule.timeAt(part * schedule.length);
  }

  /** Fraction of the showing time that has passed at a time of the motion (s), 0 to 1. */
  progressAt(time: number): number {
    const schedule = this.schedule.value;
    return schedule && schedule.length > 0 ? schedule.shownAt(time) / schedule.length : 0;
  }

  /** Seconds of the visitor that the motion has been shown for, at the present speed. */
  get shown(): number {
    return (this.schedule.value?.shownAt(this.time.value) ?? 0) / this.speed.value;
  }

  /** The time (s) that is shown after a number of the visitor's seconds, up to where playing stops. */
  timeWhen(shown: number): number {
    const time = this.schedule.value?.timeAt(shown * this.speed.value) ?? 0;
    return Math.min(time, this.until, this.end);
  }

  /** How many times slower than real time the motion is shown at present. */
  get slowdown(): number {
    return (this.schedule.value?.slowdownAt(this.time.value) ?? 1) / this.speed.value;
  }

  /** Plays from the time shown up to a time (s) or to the end. */
  play(until = Infinity): void {
    if (this.time.value >= this.end) this.time.value = 0;
    this.until = until;
    this.playing.value = true;
  }

  pause(): void {
    this.playing.value = false;
    this.until = Infinity;
  }

  toggle(): void {
    if (this.playing.value) this.pause();
    else this.play();
  }

  /** Goes back to the release. */
  rewind(): void {
    this.time.value = 0;
  }

  /** Advances by a number of the visitor's seconds; a negative number goes back. */
  advance(seconds: number): void {
    const schedule = this.schedule.value;
    if (!schedule) return;
    const shown = schedule.shownAt(this.time.value) + seconds * this.speed.value;
    if (shown >= Math.min(schedule.shownAt(this.until), schedule.length)) {
      // Set the time exactly: the conversion to shown time and back would round it.
      this.time.value = Math.min(this.until, this.end);
      this.pause();
      return;
    }
    this.time.value = schedule.timeAt(Math.max(shown, 0));
  }

  /** Moves by a number of frames, of which there are 60 in a second. */
  step(frames: number): void {
    this.pause();
    this.advance(frames / 60);
  }
}

/** Linear interpolation of y between knots at increasing x; constant beyond the ends. */
function interpolated(x: Float64Array, y: Float64Array, at_x: number): number {
  const last = x.length - 1;
  if (at_x <= at(x, 0)) return at(y, 0);
  if (at_x >= at(x, last)) return at(y, last);
  const low = knotBefore(x, at_x);
  const width = at(x, low + 1) - at(x, low);
  const part = width > 0 ? (at_x - at(x, low)) / width : 0;
  return at(y, low) + part * (at(y, low + 1) - at(y, low));
}

/** Index of the last knot, except the end, that is not beyond a place. */
function knotBefore(x: Float64Array, place: number): number {
  let [low, high] = [0, x.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (at(x, middle) <= place) low = middle;
    else high = middle;
  }
  return low;
}

const at = (array: Float64Array, index: number) => array[index] as number;
