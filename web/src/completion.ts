// The complete motion, where only the first steps have been computed at once. A worker computes it; without workers it is
// computed here after a pause, and the page waits meanwhile.

import { type ReadonlySignal, type Signal, signal } from "@preact/signals-core";
import type { Computation } from "./core/computation";
import type { Motion } from "./core/motion";

/** The complete motion is computed after this time without a change of the set-up, ms. */
const DELAY = 250;

export class Completion {
  private readonly found: Signal<Motion | undefined> = signal(undefined);
  /** The complete motion; undefined until it has been computed. */
  readonly motion: ReadonlySignal<Motion | undefined> = this.found;
  private readonly stop = new AbortController();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private begun = false;
  private waiting: (() => void) | undefined;

  constructor(private readonly computation: Computation) {}

  beginSoon(): void {
    this.timer = setTimeout(() => this.begin(), DELAY);
  }

  /** Ends the computation, because the motion is not wanted any more. */
  cancel(): void {
    clearTimeout(this.timer);
    this.stop.abort();
    this.waiting = undefined;
  }

  /** Computes the motion at once. */
  now(): void {
    if (!this.found.peek()) this.become(this.computation.now());
  }

  /** Does something as soon as the motion has been computed. */
  when(then: () => void): void {
    if (this.found.peek()) return then();
    this.waiting = then;
    this.begin();
  }

  private begin(): void {
    if (this.begun) return;
    this.begun = true;
    clearTimeout(this.timer);
    const { signal } = this.stop;
    void this.computation
      .inWorker(signal)
      .catch(console.error)
      .then((motion) => {
        if (signal.aborted) return;
        if (motion) this.become(motion);
        else this.now();
      });
  }

  private become(motion: Motion): void {
    const { waiting } = this;
    this.cancel();
    this.found.value = motion;
    waiting?.();
  }
}
