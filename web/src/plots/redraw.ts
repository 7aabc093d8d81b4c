// Schedules drawing: at most once per frame, and later for what is out of sight.

import { type ReadonlySignal, effect, signal } from "@preact/signals-core";
import { inFrame } from "../frames";

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
const SLICE = 8;

/** Gives a function that acts on one item after another, in slices of time. A new call replaces what is left of the last. */
export function inTurn<T>(act: (item: T) => void): (items: readonly T[]) => void {
  let waiting: ReturnType<typeof setTimeout> | undefined;
  return (items) => {
    clearTimeout(waiting);
    const left = [...items];
    const advance = () => {
      const end = performance.now() + SLICE;
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
