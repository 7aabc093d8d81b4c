// Which stretch of the motion all plots show. Zoomed in, it goes with the nearest collision, so that
// it still shows that collision when a slider has moved it.

import { type ReadonlySignal, type Signal, computed, signal } from "@preact/signals-core";
import type { Motion } from "../core/motion";
import { type Collision, collisionsOf, nearest } from "../time/collisions";

/** Times (s) from and to which is shown, counted from an origin: close to each other they could not
 * be told apart as times from the start. */
export interface Stretch {
  /** Of the start, a collision, or any round time. */
  since: "start" | "collision" | "time";
  origin: number;
  from: number;
  to: number;
}

/** How many times as long as a collision its close view is: nearly all of the turn is seen. */
const CLOSE_VIEW = 12;
/** Stretches shorter than this (s) are counted from their collision. */
const FROM_COLLISION = 0.05;
/** But from a round time if that many times their length away from it. */
const FAR = 30;
/** The shortest stretch, s. */
const SHORTEST = 1e-10;

export class View {
  readonly collisions: ReadonlySignal<readonly Collision[]>;
  readonly shown: ReadonlySignal<Stretch>;
  /** Times from a collision; undefined for the whole motion. */
  private readonly zoomed: Signal<{ collision: number; from: number; to: number } | undefined> =
    signal(undefined);

  constructor(private readonly motion: ReadonlySignal<Motion | undefined>) {
    this.collisions = computed(() => (motion.value ? collisionsOf(motion.value) : []));
    this.shown = computed(() => {
      const end = motion.value?.end ?? 1;
      const zoomed = this.zoomed.value;
      if (!zoomed) return { since: "start", origin: 0, from: 0, to: end };
      const at = this.collisions.value[zoomed.collision]?.t ?? 0;
      const inside = within(zoomed.from, zoomed.to, -at, end - at);
      return counted(at, inside.from, inside.to);
    });
  }

  get isWhole(): boolean {
    return this.zoomed.value === undefined;
  }

  /** Where a time (s from the start) is in what is shown: 0 at its beginning, 1 at its end. */
  placeOf(time: number): number {
    const { origin, from, to } = this.shown.value;
    return (time - origin - from) / (to - from);
  }

  whole(): void {
    this.zoomed.value = undefined;
  }

  /** Shows from one time to another, counted from the origin of what is shown now. */
  show(from: number, to: number): void {
    const end = this.motion.value?.end ?? 1;
    const { origin } = this.shown.value;
    if (from + origin <= 0 && to + origin >= end) return this.whole();
    const collision = nearest(this.collisions.value, origin + (from + to) / 2);
    const shift = origin - (this.collisions.value[collision]?.t ?? 0);
    const room = Math.max((SHORTEST * Math.max(end, 1) - (to - from)) / 2, 0);
    this.zoomed.value = { collision, from: from + shift - room, to: to + shift + room };
  }

  /** Shows less (factor above 1) or more, a time (from the origin) staying where it is. */
  zoom(factor: number, about: number): void {
    const { from, to } = this.shown.value;
    this.show(about + (from - about) / factor, about + (to - about) / factor);
  }

  /** Shows the collision nearest to a time (s from the start) so close that its turn is seen. */
  close(time: number): void {
    const collision = nearest(this.collisions.value, time);
    const half = ((this.collisions.value[collision]?.duration ?? 0) * CLOSE_VIEW) / 2;
    this.zoomed.value = half > 0 ? { collision, from: -half, to: half } : undefined;
  }
}

/** From what a stretch is best counted; times are from a collision. */
function counted(collision: number, from: number, to: number): Stretch {
  const length = to - from;
  const countedFrom = (since: Stretch["since"], origin: number): Stretch => {
    const shift = collision - origin;
    return { since, origin, from: from + shift, to: to + shift };
  };
  if (length >= FROM_COLLISION) return countedFrom("start", 0);
  const middle = (from + to) / 2;
  if (Math.abs(middle) < FAR * length) return countedFrom("collision", collision);
  const round = 10 ** Math.ceil(Math.log10(length));
  return countedFrom(
    "time",
    Number((Math.round((collision + middle) / round) * round).toPrecision(12)),
  );
}

/** A stretch moved into bounds, and cut to them if it is longer. */
function within(from: number, to: number, low: number, high: number): { from: number; to: number } {
  const shift = Math.max(low - from, 0) - Math.max(to - high, 0);
  return { from: Math.max(from + shift, low), to: Math.min(to + shift, high) };
}
