// The stretch of the motion that all plots show. A zoomed stretch is stored relative to the nearest
// collision, so that it follows that collision when a slider moves it.

import { computed, type ReadonlySignal, type Signal, signal } from "@preact/signals-core";
import { type Collision, collisionsOf, type Motion, nearest } from "../core/motion";

/** The start and end of the stretch, s, counted from an origin: as times from the start of the motion,
 * close ones could not be distinguished. */
export interface Stretch {
  /** What the origin is: the start, a collision, or a round time. */
  since: "start" | "collision" | "time";
  origin: number;
  from: number;
  to: number;
}

/** Length of the close view over the duration of the collision; it contains nearly all of the turn. */
const CLOSE_VIEW = 12;
/** Shorter stretches than this (s) are counted from their collision. */
const FROM_COLLISION = 0.05;
/** Stretches further from the collision than this many lengths are counted from a round time. */
const FAR = 30;
/** The shortest stretch, s. */
const SHORTEST = 1e-10;

export class View {
  readonly collisions: ReadonlySignal<readonly Collision[]>;
  readonly shown: ReadonlySignal<Stretch>;
  /** Times relative to a collision, s; undefined for the whole motion. */
  private readonly zoomed: Signal<{ collision: number; from: number; to: number } | undefined> =
    signal(undefined);

  /** `last` is the end of what is shown, s; by default that of the motion. */
  constructor(
    motion: ReadonlySignal<Motion | undefined>,
    private readonly last: ReadonlySignal<number> = computed(() => motion.value?.end ?? 0),
  ) {
    this.collisions = computed(() => (motion.value ? collisionsOf(motion.value) : []));
    this.shown = computed(() => {
      const end = last.value || 1;
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

  /** Place of a time (s from the start) in the stretch shown: 0 at its start, 1 at its end. */
  placeOf(time: number): number {
    const { origin, from, to } = this.shown.value;
    return (time - origin - from) / (to - from);
  }

  whole(): void {
    this.zoomed.value = undefined;
  }

  /** Shows a stretch, whose times are counted from the current origin. */
  show(from: number, to: number): void {
    const end = this.last.value || 1;
    const { origin } = this.shown.value;
    if (from + origin <= 0 && to + origin >= end) return this.whole();
    const collision = nearest(this.collisions.value, origin + (from + to) / 2);
    const shift = origin - (this.collisions.value[collision]?.t ?? 0);
    const room = Math.max((SHORTEST * Math.max(end, 1) - (to - from)) / 2, 0);
    this.zoomed.value = { collision, from: from + shift - room, to: to + shift + room };
  }

  /** Zooms in (factor above 1) or out about a time, which is counted from the current origin. */
  zoom(factor: number, about: number): void {
    const { from, to } = this.shown.value;
    this.show(about + (from - about) / factor, about + (to - about) / factor);
  }

  /** Shows the turn of the collision nearest to a time (s from the start). */
  close(time: number): void {
    const collision = nearest(this.collisions.value, time);
    const half = ((this.collisions.value[collision]?.duration ?? 0) * CLOSE_VIEW) / 2;
    this.zoomed.value = half > 0 ? { collision, from: -half, to: half } : undefined;
  }
}

/** Chooses the origin of a stretch whose times are relative to a collision. */
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

/** Moves a stretch into bounds and cuts it if it is longer. */
function within(from: number, to: number, low: number, high: number): { from: number; to: number } {
  const shift = Math.max(low - from, 0) - Math.max(to - high, 0);
  return { from: Math.max(from + shift, low), to: Math.min(to + shift, high) };
}
