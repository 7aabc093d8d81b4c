// The state of the page: the set-up, the motion computed from it, and the time at which it is shown.
// Every part of the page reads these signals, so that a change of the set-up updates all of them.

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
import type { Displacement, Shaker, Shaking } from "./floor/shaking";
import { type Flick, flicksOf } from "./falls/flicks";
import { sliced } from "./falls/sliced";
import { type Preview, previewOf } from "./falls/preview";
import { type SimulationInput, simulationInput } from "./setup/simulation_input";
import { FLICK_FIELDS } from "./setup/fields";
import type { Held } from "./setup/release";
import { INITIAL_PLAYBACK, type Playback, type ViewName } from "./setup/playback";
import type { Refusal } from "./setup/refusal";
import { INITIAL, type Setup } from "./setup/setup";
import { words } from "./words/words";

/** The result for a set-up: a motion, or the reason why there is none. */
export type Outcome = Simulated | { refused: string };

export interface Simulated {
  input: SimulationInput;
  motion: Motion;
  theory: Theory;
  /** Whether only the first steps of the motion have been computed; see {@link Lab.complete}. */
  partial: boolean;
}

/** What the picture marks beside the motion. */
export interface Marks {
  /** Whether it shows the limits of theory. */
  theory: boolean;
  /** A guess of the angle of turn, rad; undefined if there is none. */
  guess: number | undefined;
}

/** Number of steps computed at once when the set-up changes; they take a few ms. */
const FIRST_STEPS = 2000;
/** The remaining steps are computed after this time without a change, ms. */
const COMPLETION_DELAY = 250;

/** Changes of the set-up with shorter pauses between them are undone together, ms. */
const UNDO_PAUSE = 700;
/** Largest number of changes that can be undone. */
const MAX_UNDO = 100;

/** The turn at the time shown: its angle so far, in rad, from the time (s) at which it starts. */
export interface TurnProgress {
  angle: number;
  /** Rotation of the body itself about its axis since then, rad; see {@link headingOf}. */
  bodyAngle: number;
  start: number;
  /** Yaw at the start, rad. */
  startYaw: number;
  /** The complete turn; undefined if the motion ends before it is complete. */
  turn: Turn | undefined;
}

/** Rotation of the body itself, rad: positive in the direction in which the contact point runs. */
export const bodyAngleAlongContact = ({ angle, bodyAngle, turn }: TurnProgress): number =>
  bodyAngle * (Math.sign(turn?.angle ?? angle) || 1);

export class Lab {
  readonly setup: Signal<Readonly<Setup>> = signal(INITIAL);
  /** The latest refusal of each field. */
  readonly refusals: Signal<readonly Refusal[]> = signal([]);
  /** How a visitor holds the body; while it is held, time stands still. */
  readonly held: Signal<Held | undefined> = signal(undefined);
  /** The fall of the held body if the hand let go at rest now. */
  readonly preview: ReadonlySignal<Preview | undefined>;
  /** How many flicks are shown; undefined if the visitor has not started any. */
  readonly flicksShown: Signal<number | undefined> = signal(undefined);
  /** Whether the flicks are still appearing one after the other. */
  readonly flicking: Signal<boolean> = signal(false);
  /** Results of all flicks that have been computed, including those not shown yet. */
  readonly flicks: ReadonlySignal<readonly Flick[]>;
  /** Whether all wanted flicks have been computed. */
  readonly flicksComplete: ReadonlySignal<boolean>;
  readonly outcome: ReadonlySignal<Outcome>;
  /** What shakes the floor; undefined until a set-up needs it and it is loaded. */
  readonly shaker: Signal<Shaker | undefined> = signal(undefined);
  /** Why there is no shaker, as the end of a sentence. */
  readonly shakerMissing: Signal<string> = signal(words.floor.isLoading);
  /** Where a hand holds the table, m; undefined if none does. */
  readonly tableHeld: Signal<Displacement | undefined> = signal(undefined);
  /** From where the body is seen. */
  readonly view: Signal<ViewName> = signal(INITIAL_PLAYBACK.view);
  readonly marks: Signal<Readonly<Marks>> = signal({ theory: true, guess: undefined });
  /** Step of the story, counted from 0. */
  readonly step: Signal<number> = signal(0);
  /** Set-ups before the latest changes. */
  private readonly before: Signal<readonly Readonly<Setup>[]> = signal([]);
  private changed = -Infinity;
  readonly canUndo: ReadonlySignal<boolean> = computed(() => this.before.value.length > 0);
  /** Azimuth of the camera, rad. */
  azimuth = -Math.PI / 2;
  /** Whether the complete motion is wanted, however long that takes. */
  private readonly completeWanted: Signal<boolean> = signal(false);
  readonly motion: ReadonlySignal<Motion | undefined>;
  readonly theory: ReadonlySignal<Theory | undefined>;
  readonly clock: Clock;
  /** The state of the motion at the time shown. */
  readonly moment: ReadonlySignal<Moment | undefined>;
  readonly turnProgress: ReadonlySignal<TurnProgress | undefined>;
  /** How the floor moves, if it moves. */
  readonly shaking: ReadonlySignal<Shaking | undefined>;

  constructor(readonly core: Core) {
    const release = computed(() => withoutFlicks(this.setup.value));
    this.outcome = computed(() => {
      const maxSteps = this.completeWanted.value ? Infinity : FIRST_STEPS;
      const setup = JSON.parse(release.value) as Setup;
      if (setup.floor === "rest") return outcomeOf(core, undefined, setup, maxSteps);
      const shaker = this.shaker.value;
      if (shaker) return outcomeOf(core, shaker, setup, maxSteps);
      return { refused: this.shakerMissing.value };
    });
    this.motion = computed(() =>
      "motion" in this.outcome.value ? this.outcome.value.motion : undefined,
    );
    this.theory = computed(() =>
      "theory" in this.outcome.value ? this.outcome.value.theory : undefined,
    );
    this.shaking = computed(() =>
      "motion" in this.outcome.value ? this.outcome.value.input.shaking : undefined,
    );
    this.preview = computed(() => {
      const held = this.held.value;
      return held && previewOf(core, this.setup.value, held);
    });
    this.clock = new Clock(this.motion);
    this.moment = computed(() => this.motion.value?.at([this.clock.time.value]).moment(0));
    this.turnProgress = computed(() => this.turnProgressAt(this.clock.time.value));
    // Compute all flicks once, not again for each one shown.
    const wanted = computed(() => this.flicksShown.value !== undefined);
    const flicks = sliced(() =>
      wanted.value ? flicksOf(core, this.setup.value) : ([] as Flick[]).values(),
    );
    this.flicks = flicks.results;
    this.flicksComplete = flicks.complete;
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

  /** Changes a part of the set-up and shows the new motion from the release. */
  change(part: Partial<Setup>): void {
    this.remember(part);
    this.set({ ...this.setup.value, ...part });
  }

  /** Goes back to the set-up before the latest change. */
  undo(): void {
    const setup = this.before.value.at(-1);
    if (!setup) return;
    this.before.value = this.before.value.slice(0, -1);
    this.changed = -Infinity;
    this.set(setup);
  }

  /** Forgets all earlier set-ups, so that nothing before this one can be restored. */
  beginHere(): void {
    this.before.value = [];
  }

  /** Keeps the set-up for {@link undo}, but only one for changes that follow each other quickly, as a slider's do. */
  private remember(part: Partial<Setup>): void {
    const old = this.setup.value;
    const differs = (name: string) => part[name as keyof Setup] !== old[name as keyof Setup];
    if (!Object.keys(part).some(differs)) return;
    const now = performance.now();
    if (now - this.changed > UNDO_PAUSE)
      this.before.value = [...this.before.value.slice(1 - MAX_UNDO), old];
    this.changed = now;
  }

  private set(setup: Readonly<Setup>): void {
    batch(() => {
      if (withoutFlicks(setup) !== withoutFlicks(this.setup.value)) {
        this.clock.pause();
        this.clock.rewind();
        this.completeWanted.value = false;
      }
      // No more flicks can be shown than there are.
      if ((this.flicksShown.value ?? 0) > setup.flicks) this.flicksShown.value = setup.flicks;
      this.setup.value = setup;
    });
  }

  get playback(): Playback {
    const { speed, stretched } = this.clock;
    return { speed: speed.value, stretched: stretched.value, view: this.view.value };
  }

  setPlayback({ speed, stretched, view }: Readonly<Playback>): void {
    batch(() => {
      this.clock.speed.value = speed;
      this.clock.stretched.value = stretched;
      this.view.value = view;
    });
  }

  /** Computes the remaining steps of the motion, if only the first have been computed. */
  complete(): void {
    if (isPartial(this.outcome.peek())) this.completeWanted.value = true;
  }

  private turnProgressAt(time: number): TurnProgress | undefined {
    const motion = this.motion.value;
    const moment = this.moment.value;
    if (!motion || !moment) return undefined;
    const turn = motion.turns.find((turn) => time <= turn.end);
    const previous = motion.turns.findLast((turn) => turn.end <= time);
    const start = turn?.start ?? previous?.end ?? 0;
    const first = motion.at([start]).moment(0);
    const bodyAngle = headingOf(moment) - headingOf(first);
    return { angle: moment.yaw - first.yaw, bodyAngle, start, startYaw: first.yaw, turn };
  }
}

/** The fields on which one motion depends, as a text that can be compared. */
function withoutFlicks(setup: Readonly<Setup>): string {
  const hidden: readonly string[] = FLICK_FIELDS;
  return JSON.stringify(setup, (name, value: unknown) =>
    hidden.includes(name) ? undefined : value,
  );
}

const isPartial = (outcome: Outcome) => "motion" in outcome && outcome.partial;

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
