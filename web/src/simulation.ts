// The motion that is computed from a set-up: its first steps at once, the others a little later in a worker.

import { computed, effect, type ReadonlySignal, type Signal, signal } from "@preact/signals-core";
import type { Computation } from "./core/computation";
import type { Core, Theory } from "./core/core";
import type { Motion } from "./core/motion";
import { reasonOrRethrow, type SimulationInput, simulationInput } from "./setup/simulation_input";
import type { Shaker, Shaking } from "./floor/shaking";
import { FLICK_FIELDS } from "./setup/fields";
import type { Setup } from "./setup/setup";

/** The result for a set-up: a motion, or the reason why there is none. */
export type Outcome = Simulated | { refused: string };

export interface Simulated {
  input: SimulationInput;
  motion: Motion;
  theory: Theory;
  /** Whether only the first steps of the motion have been computed; see {@link Simulation.whenComplete}. */
  partial: boolean;
}

/** Number of steps computed at once when the set-up changes; they take a few ms. */
const FIRST_STEPS = 2000;

/** What shakes the floor, and why it is missing if it is, in words. */
export interface Shakers {
  shaker: ReadonlySignal<Shaker | undefined>;
  shakerMissing: ReadonlySignal<string>;
}

export class Simulation {
  readonly outcome: ReadonlySignal<Outcome | undefined>;
  readonly motion: ReadonlySignal<Motion | undefined>;
  readonly theory: ReadonlySignal<Theory | undefined>;
  /** How the floor moves, if it moves. */
  readonly shaking: ReadonlySignal<Shaking | undefined>;
  private readonly first: ReadonlySignal<First | undefined>;

  /** Without a set-up there is no outcome. */
  constructor(
    core: Core,
    setup: ReadonlySignal<Readonly<Setup> | undefined>,
    { shaker, shakerMissing }: Shakers,
  ) {
    const release = computed(() => setup.value && withoutFlicks(setup.value));
    this.first = computed(() => {
      if (release.value === undefined) return undefined;
      const setup = JSON.parse(release.value) as Setup;
      if (setup.floor === "rest") return firstOf(core, undefined, setup);
      if (shaker.value) return firstOf(core, shaker.value, setup);
      return { outcome: { refused: shakerMissing.value } };
    });
    this.outcome = computed(() => {
      const first = this.first.value;
      const motion = first?.completion?.motion.value;
      return motion ? { ...first.outcome, motion, partial: false } : first?.outcome;
    });
    const simulated = computed(() => {
      const outcome = this.outcome.value;
      return outcome && "motion" in outcome ? outcome : undefined;
    });
    this.motion = computed(() => simulated.value?.motion);
    this.theory = computed(() => simulated.value?.theory);
    this.shaking = computed(() => simulated.value?.input.shaking);
    effect(() => {
      const completion = this.first.value?.completion;
      completion?.beginSoon();
      return () => completion?.cancel();
    });
    let current: Motion | undefined;
    effect(() => {
      // Parts of the page may still draw the previous motion in this frame, but not in the next.
      const previous = current;
      current = this.motion.value;
      if (previous && previous !== current) requestAnimationFrame(() => previous.forget());
    });
  }

  /** Computes the remaining steps of the motion now, if only the first have been computed. */
  complete(): void {
    this.first.peek()?.completion?.now();
  }

  /** Does something when all steps of the motion have been computed, unless the set-up changes before. */
  whenComplete(then: () => void): void {
    const completion = this.first.peek()?.completion;
    if (completion) completion.when(then);
    else then();
  }
}

/** What the first steps of a motion give, and the computation of all steps if there are more. */
type First =
  { outcome: Simulated; completion: Completion } | { outcome: Outcome; completion?: never };

/** The fields on which one motion depends, as a text that can be compared. */
export function withoutFlicks(setup: Readonly<Setup>): string {
  const hidden: readonly string[] = FLICK_FIELDS;
  return JSON.stringify(setup, (name, value: unknown) =>
    hidden.includes(name) ? undefined : value,
  );
}

/** Computes the first steps of the motion. */
function firstOf(core: Core, shaker: Shaker | undefined, setup: Readonly<Setup>): First {
  try {
    const atRest = simulationInput(core, setup);
    const input = shaker ? shaker.inputOf(setup, atRest) : atRest;
    const { body, start, contactLaw, options } = input;
    const motion = computationOf(core, input, FIRST_STEPS).now();
    try {
      const theory = core.theory(body, start, contactLaw, options.gravity);
      const partial = FIRST_STEPS < options.maxSteps && motion.ranOutOfSteps;
      const outcome = { input, motion, theory, partial };
      if (!partial) return { outcome };
      return { outcome, completion: new Completion(computationOf(core, input, options.maxSteps)) };
    } catch (error) {
      motion.forget();
      throw error;
    }
  } catch (error) {
    return { outcome: { refused: reasonOrRethrow(error) } };
  }
}

function computationOf(core: Core, input: SimulationInput, limit: number): Computation {
  const maxSteps = Math.min(limit, input.options.maxSteps);
  const limited = { ...input, options: { ...input.options, maxSteps } };
  if (input.shaking) return input.shaking.simulation(limited);
  return core.simulation(limited.body, limited.start, limited.contactLaw, limited.options);
}

// The complete motion, where only the first steps have been computed at once. A worker computes it; without workers it is
// computed here after a pause, and the page waits meanwhile.

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
