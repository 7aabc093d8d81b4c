// The motion that is computed from a set-up: its first steps at once, the others a little later.

import { type ReadonlySignal, type Signal, computed, effect, signal } from "@preact/signals-core";
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
  /** Whether only the first steps of the motion have been computed; see {@link Simulation.complete}. */
  partial: boolean;
}

/** Number of steps computed at once when the set-up changes; they take a few ms. */
const FIRST_STEPS = 2000;
/** The remaining steps are computed after this time without a change, ms. */
const COMPLETION_DELAY = 250;

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
  /** Whether the complete motion is wanted, however long that takes. */
  private readonly completeWanted: Signal<boolean> = signal(false);

  /** Without a set-up there is no outcome. */
  constructor(
    core: Core,
    setup: ReadonlySignal<Readonly<Setup> | undefined>,
    { shaker, shakerMissing }: Shakers,
  ) {
    const release = computed(() => setup.value && withoutFlicks(setup.value));
    this.outcome = computed(() => {
      if (release.value === undefined) return undefined;
      const maxSteps = this.completeWanted.value ? Infinity : FIRST_STEPS;
      const setup = JSON.parse(release.value) as Setup;
      if (setup.floor === "rest") return outcomeOf(core, undefined, setup, maxSteps);
      if (shaker.value) return outcomeOf(core, shaker.value, setup, maxSteps);
      return { refused: shakerMissing.value };
    });
    const simulated = computed(() => {
      const outcome = this.outcome.value;
      return outcome && "motion" in outcome ? outcome : undefined;
    });
    this.motion = computed(() => simulated.value?.motion);
    this.theory = computed(() => simulated.value?.theory);
    this.shaking = computed(() => simulated.value?.input.shaking);
    effect(() => {
      if (!isPartial(this.outcome.value)) return undefined;
      const timer = setTimeout(() => this.complete(), COMPLETION_DELAY);
      return () => clearTimeout(timer);
    });
    let current: Motion | undefined;
    effect(() => {
      // Parts of the page may still draw the previous motion in this frame, but not in the next.
      const previous = current;
      current = this.motion.value;
      if (previous && previous !== current) requestAnimationFrame(() => previous.forget());
    });
  }

  /** Computes the remaining steps of the motion, if only the first have been computed. */
  complete(): void {
    if (isPartial(this.outcome.peek())) this.completeWanted.value = true;
  }

  /** Computes the first steps only when the set-up changes next. */
  begin(): void {
    this.completeWanted.value = false;
  }
}

/** The fields on which one motion depends, as a text that can be compared. */
export function withoutFlicks(setup: Readonly<Setup>): string {
  const hidden: readonly string[] = FLICK_FIELDS;
  return JSON.stringify(setup, (name, value: unknown) =>
    hidden.includes(name) ? undefined : value,
  );
}

const isPartial = (outcome: Outcome | undefined) =>
  outcome !== undefined && "motion" in outcome && outcome.partial;

/** Computes the motion with a limited number of steps. */
function outcomeOf(
  core: Core,
  shaker: Shaker | undefined,
  setup: Readonly<Setup>,
  limit: number,
): Outcome {
  try {
    const atRest = simulationInput(core, setup);
    const input = shaker ? shaker.inputOf(setup, atRest) : atRest;
    const { body, start, contactLaw, options, shaking } = input;
    const maxSteps = Math.min(limit, options.maxSteps);
    const limited = { ...options, maxSteps };
    const motion = shaking
      ? shaking.simulate({ ...input, options: limited })
      : core.simulate(body, start, contactLaw, limited);
    try {
      const theory = core.theory(body, start, contactLaw, options.gravity);
      const partial = maxSteps < options.maxSteps && motion.ranOutOfSteps;
      return { input, motion, theory, partial };
    } catch (error) {
      motion.forget();
      throw error;
    }
  } catch (error) {
    return { refused: reasonOrRethrow(error) };
  }
}
