// When to draw: not more often than the screen shows it, and first what is looked at.

import { type ReadonlySignal, effect, signal } from "@preact/signals-core";

/** Does something before the next picture is painted whenever signals have changed. */
export function oncePerFrame(read: () => unknown, act: () => void): void {
  let waiting = false;
  effect(() => {
    read();
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      act();
    });
  });
}

/** How long nothing changes before what is out of sight is brought up to date, ms. */
const QUIET = 400;

/** Does something when signals have not changed for a while. */
export function onceIdle(read: () => unknown, act: () => void): void {
  let waiting: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    read();
    clearTimeout(waiting);
    waiting = setTimeout(act, QUIET);
  });
}

/** Which elements are in sight, or nearly. */
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
