// When the page does its work: in frames of the screen, in slices of time, or when nothing has changed for a while.

import { batch, effect, type ReadonlySignal, signal } from "@preact/signals-core";
import type { Clock } from "./clock";

type Act = (now: number) => void;

/** What is to be done in the present frame; undefined between frames. */
let waiting: Act[] | undefined;

/** Does something in the present frame, after time has advanced, or else in the next one. */
export function inFrame(act: Act): void {
  if (waiting) waiting.push(act);
  else requestAnimationFrame(act);
}

/** Advances in a frame at a time (ms), and then does what has been asked for meanwhile. */
export function advanceFrame(now: number, advance: () => void): void {
  waiting = [];
  try {
    advance();
  } finally {
    const acts = waiting;
    waiting = undefined;
    for (const act of acts) act(now);
  }
}

// Advances the clock once per frame while it plays. While the page is hidden, the browser draws no
// frames, so time stands still.

/** Longest time that one frame advances, s: time lost while the page was paused is not made up. */
const MAX_FRAME = 0.1;

export function startTicker(clock: Clock): void {
  let before: number | undefined;
  const tick = (now: number) => {
    if (!clock.playing.peek()) {
      before = undefined;
      return;
    }
    try {
      const passed = before === undefined ? 0 : Math.min((now - before) / 1000, MAX_FRAME);
      advanceFrame(now, () => clock.advance(passed));
    } catch (error) {
      // Pressing play again must start it again.
      before = undefined;
      clock.pause();
      throw error;
    }
    before = now;
    requestAnimationFrame(tick);
  };
  effect(() => {
    if (clock.playing.value && before === undefined) {
      before = performance.now();
      requestAnimationFrame(tick);
    }
  });
}

// Schedules drawing: at most once per frame, and later for what is out of sight.

/** Runs an action in the next frame after signals have changed. */
export function oncePerFrame(read: () => unknown, act: () => void): void {
  let waiting = false;
  effect(() => {
    read();
    if (waiting) return;
    waiting = true;
    inFrame(() => {
      waiting = false;
      act();
    });
  });
}

/** Time without a change before plots out of sight are updated, ms. */
const IDLE = 400;

/** Runs an action when signals have not changed for a while. */
export function onceIdle(read: () => unknown, act: () => void): void {
  let waiting: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    read();
    clearTimeout(waiting);
    waiting = setTimeout(act, IDLE);
  });
}

/** Time after which the next item waits for what the visitor does, ms. */
const AT_ONCE = 8;

/** Gives a function that acts on one item after another, in slices of time. A new call replaces what is left of the last. */
export function inTurn<T>(act: (item: T) => void): (items: readonly T[]) => void {
  let waiting: ReturnType<typeof setTimeout> | undefined;
  return (items) => {
    clearTimeout(waiting);
    const left = [...items];
    const advance = () => {
      const end = performance.now() + AT_ONCE;
      for (let item = left.shift(); item !== undefined; item = left.shift()) {
        act(item);
        if (performance.now() >= end) break;
      }
      if (left.length > 0) waiting = setTimeout(advance);
    };
    advance();
  };
}

/** The elements that are in sight or nearly so. */
export function inSight(elements: readonly Element[]): ReadonlySignal<ReadonlySet<Element>> {
  const seen = signal<ReadonlySet<Element>>(new Set());
  const observer = new IntersectionObserver(
    (entries) => {
      const now = new Set(seen.value);
      for (const { target, isIntersecting } of entries)
        if (isIntersecting) now.add(target);
        else now.delete(target);
      seen.value = now;
    },
    { rootMargin: "25%" },
  );
  for (const one of elements) observer.observe(one);
  return seen;
}

// Computes a sequence in slices of time, so that the page answers its visitor meanwhile.

/** Browsers call a task of more than 50 ms long; a slice is much shorter, and its last part may exceed it. */
const SLICE = 20;
/** Results are published at this interval, ms, because those who read them draw all of them. */
const INTERVAL = 100;

export interface Sliced<T> {
  /** The results so far. */
  results: ReadonlySignal<readonly T[]>;
  /** Whether all have been computed. */
  complete: ReadonlySignal<boolean>;
}

/** Takes the items of the sequence that `begin` gives, and begins anew when a signal that `begin` reads changes.
 * The first slice is computed at once. */
export function sliced<T>(begin: () => Iterator<T, void>): Sliced<T> {
  const results = signal<readonly T[]>([]);
  const complete = signal(true);
  effect(() => {
    const items = begin();
    let timer: ReturnType<typeof setTimeout> | undefined;
    const all: T[] = [];
    let published = -Infinity;
    const advance = () => {
      const end = performance.now() + SLICE;
      let item = items.next();
      while (!item.done) {
        all.push(item.value);
        if (performance.now() >= end) break;
        item = items.next();
      }
      const { done = false } = item;
      if (done || performance.now() - published >= INTERVAL) {
        published = performance.now();
        batch(() => {
          results.value = [...all];
          complete.value = done;
        });
      }
      if (!done) timer = setTimeout(advance);
    };
    advance();
    return () => clearTimeout(timer);
  });
  return { results, complete };
}

// The visitor's preference for reduced motion, as the browser reports it.

export const prefersReducedMotion = (): boolean =>
  matchMedia("(prefers-reduced-motion: reduce)").matches;
