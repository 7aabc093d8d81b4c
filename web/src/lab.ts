// What the page is about: the set-up, the motion that follows from it, and the time at which it is
// shown. Everything on the page reads these signals; whoever changes the set-up changes all of it.

import {
  type ReadonlySignal,
  type Signal,
  batch,
  computed,
  effect,
  signal,
} from "@preact/signals-core";
import { Clock } from "./clock";
import type { Core, Theory } from "./core/core";
import { type Moment, type Motion, type Turn, headingOf } from "./core/motion";
import { reasonOrRethrow } from "./core/reason";
import { type Flick, simulateFlicks } from "./falls/flicks";
import { type Preview, previewOf } from "./falls/preview";
import { type SimulationInput, simulationInput } from "./setup/simulation_input";
import { FLICK_FIELDS } from "./setup/fields";
import type { Held } from "./setup/release";
import type { Refusal } from "./setup/refusal";
import { INITIAL, type Setup } from "./setup/setup";

/** What came of a set-up: a motion, or the reason why there is none. */
export type Outcome = Simulated | { refused: string };

export interface Simulated {
  input: SimulationInput;
  motion: Motion;
  theory: Theory;
  /** Whether the motion is only the beginning of what was asked for; see {@link Lab.complete}. */
  partial: boolean;
}

/** A slider waits for so many steps of a motion, some ms. */
const FIRST_STEPS = 2000;
/** The rest of a longer one is computed when nothing has changed for so long, ms. */
const COMPLETION_DELAY = 250;

/** The angle of turn as far as it has come: rad, from the time (s) at which it begins. */
export interface TurnProgress {
  angle: number;
  /** How far the body itself has turned about its axis meanwhile, rad; see {@link headingOf}. */
  own: number;
  start: number;
  /** Yaw then. */
  from: number;
  /** The whole of it; none if the motion ends on the way. */
  whole: Turn | undefined;
}

/** How far the body itself has turned, rad: positive the way that the contact point runs. */
export const bodyAngleAlongContact = ({ angle, own, whole }: TurnProgress): number =>
  own * (Math.sign(whole?.angle ?? angle) || 1);

export class Lab {
  readonly setup: Signal<Readonly<Setup>> = signal(INITIAL);
  /** What was refused last, field by field. */
  readonly refusals: Signal<readonly Refusal[]> = signal([]);
  /** The body in a visitor's hand; while it is held nothing moves. */
  readonly held: Signal<Held | undefined> = signal(undefined);
  /** What would become of it there, if the hand let go. */
  readonly preview: ReadonlySignal<Preview | undefined>;
  /** How many of the repeated flicks are shown; undefined while none were asked for. */
  readonly flicksShown: Signal<number | undefined> = signal(undefined);
  /** Whether more of them are on their way. */
  readonly flicking: Signal<boolean> = signal(false);
  /** What becomes of all of them, those not made yet included. */
  readonly flicks: ReadonlySignal<readonly Flick[]>;
  readonly outcome: ReadonlySignal<Outcome>;
  /** Whether all of the motion is wanted now, however long that takes. */
  private readonly completeWanted: Signal<boolean> = signal(false);
  readonly motion: ReadonlySignal<Motion | undefined>;
  readonly theory: ReadonlySignal<Theory | undefined>;
  readonly clock: Clock;
  /** The motion at the time shown. */
  readonly moment: ReadonlySignal<Moment | undefined>;
  readonly turnProgress: ReadonlySignal<TurnProgress | undefined>;

  constructor(readonly core: Core) {
    const release = computed(() => withoutFlicks(this.setup.value));
    this.outcome = computed(() => {
      const most = this.completeWanted.value ? Infinity : FIRST_STEPS;
      return outcomeOf(core, JSON.parse(release.value) as Setup, most);
    });
    this.motion = computed(() =>
      "motion" in this.outcome.value ? this.outcome.value.motion : undefined,
    );
    this.theory = computed(() =>
      "theory" in this.outcome.value ? this.outcome.value.theory : undefined,
    );
    this.preview = computed(() => {
      const held = this.held.value;
      return held && previewOf(core, this.setup.value, held);
    });
    this.clock = new Clock(this.motion);
    this.moment = computed(() => this.motion.value?.at([this.clock.time.value]).moment(0));
    this.turnProgress = computed(() => this.turnProgressAt(this.clock.time.value));
    // Computed once, not anew for each that is shown.
    const asked = computed(() => this.flicksShown.value !== undefined);
    this.flicks = computed(() => (asked.value ? simulateFlicks(core, this.setup.value) : []));
    effect(() => {
      if (!isPartial(this.outcome.value)) return undefined;
      const resting = setTimeout(() => this.complete(), COMPLETION_DELAY);
      return () => clearTimeout(resting);
    });
    let before: Motion | undefined;
    effect(() => {
      // Whoever still draws the motion before has done so by the next picture.
      const gone = before;
      before = this.motion.value;
      if (gone && gone !== before) requestAnimationFrame(() => gone.forget());
    });
  }

  /** Changes some of the set-up and shows the motion that follows from the beginning. */
  change(part: Partial<Setup>): void {
    const setup = { ...this.setup.value, ...part };
    batch(() => {
      if (withoutFlicks(setup) !== withoutFlicks(this.setup.value)) {
        this.clock.pause();
        this.clock.rewind();
        this.completeWanted.value = false;
      }
      // Of fewer flicks no more can have been made.
      if ((this.flicksShown.value ?? 0) > setup.flicks) this.flicksShown.value = setup.flicks;
      this.setup.value = setup;
    });
  }

  /** Computes the rest of a motion of which there is only the beginning. */
  complete(): void {
    if (isPartial(this.outcome.peek())) this.completeWanted.value = true;
  }

  private turnProgressAt(time: number): TurnProgress | undefined {
    const motion = this.motion.value;
    const moment = this.moment.value;
    if (!motion || !moment) return undefined;
    const whole = motion.turns.find((turn) => time <= turn.end);
    const before = motion.turns.findLast((turn) => turn.end <= time);
    const start = whole?.start ?? before?.end ?? 0;
    const first = motion.at([start]).moment(0);
    const own = headingOf(moment) - headingOf(first);
    return { angle: moment.yaw - first.yaw, own, start, from: first.yaw, whole };
  }
}

/** What one motion depends on, to be compared. */
function withoutFlicks(setup: Readonly<Setup>): string {
  const hidden: readonly string[] = FLICK_FIELDS;
  return JSON.stringify(setup, (name, value: unknown) =>
    hidden.includes(name) ? undefined : value,
  );
}

const isPartial = (outcome: Outcome) => "motion" in outcome && outcome.partial;

/** Of the motion no more than so many steps. */
function outcomeOf(core: Core, setup: Readonly<Setup>, most: number): Outcome {
  try {
    const input = simulationInput(core, setup);
    const { body, start, contactLaw, options } = input;
    const maxSteps = Math.min(most, options.maxSteps);
    const motion = core.simulate(body, start, contactLaw, { ...options, maxSteps });
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
