// Computes a sequence in slices of time, so that the page answers its visitor meanwhile.

import { type ReadonlySignal, batch, effect, signal } from "@preact/signals-core";

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
