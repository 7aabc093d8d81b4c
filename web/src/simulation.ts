// The motion that is computed from a set-up: its first steps at once, the others a little later in a worker.

import { type ReadonlySignal, computed, effect } from "@preact/signals-core";
import { Completion } from "./completion";
import type { Computation } from "./core/computation";
import type { Core, Theory } from "./core/core";
import type { Motion } from "./core/motion";
import { reasonOrRethrow } from "./core/reason";
import type { Shaker, Shaking } from "./floor/shaking";
import { FLICK_FIELDS } from "./setup/fields";
import type { Setup } from "./setup/setup";
import { type SimulationInput, simulationInput } from "./setup/simulation_input";

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
