// The state of the page: the set-up, the motion computed from it, and the time at which it is shown.
// Every part of the page reads these signals, so that a change of the set-up updates all of them.

import { batch, computed, type ReadonlySignal, type Signal, signal } from "@preact/signals-core";
import { Clock } from "./clock";
import type { Core, Theory } from "./core/core";
import { headingOf, type Moment, type Motion, type Turn } from "./core/motion";
import type { Displacement, Shaker, Shaking } from "./floor/shaking";
import { type Flick, flicksOf, type Preview, previewOf } from "./falls/flicks";
import { sliced } from "./timing";
import type { Held } from "./setup/release";
import { INITIAL_PLAYBACK, type Playback, type ViewName } from "./setup/playback";
import type { Refusal } from "./setup/fields";
import { INITIAL, type Setup } from "./setup/setup";
import { type Outcome, Simulation, withoutFlicks } from "./simulation";
import { words } from "./words/words";

export type { Outcome, Simulated } from "./simulation";

/** What the picture marks beside the motion. */
export interface Marks {
  /** Whether it shows the limits of theory. */
  theory: boolean;
  /** A guess of the angle of turn, rad; undefined if there is none. */
  guess: number | undefined;
}

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

/** A set-up and the one that it is compared with. */
interface Compared {
  setup: Readonly<Setup>;
  other: Readonly<Setup> | undefined;
}

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
  /** A second set-up, whose motion is shown beside this one; undefined if nothing is compared. */
  readonly otherSetup: Signal<Readonly<Setup> | undefined> = signal(undefined);
  /** The motion of the second set-up. */
  readonly other: Simulation;
  /** The state of the second motion at the time shown, and its turn. */
  readonly otherMoment: ReadonlySignal<Moment | undefined>;
  readonly otherProgress: ReadonlySignal<TurnProgress | undefined>;
  /** End of the longer motion, s. */
  readonly end: ReadonlySignal<number>;
  /** Set-ups before the latest changes, each with the second one. */
  private readonly before: Signal<readonly Compared[]> = signal([]);
  private changed = -Infinity;
  readonly canUndo: ReadonlySignal<boolean> = computed(() => this.before.value.length > 0);
  /** Azimuth of the camera, rad. */
  azimuth = -Math.PI / 2;
  private readonly simulation: Simulation;
  readonly motion: ReadonlySignal<Motion | undefined>;
  readonly theory: ReadonlySignal<Theory | undefined>;
  readonly clock: Clock;
  /** The state of the motion at the time shown. */
  readonly moment: ReadonlySignal<Moment | undefined>;
  readonly turnProgress: ReadonlySignal<TurnProgress | undefined>;
  /** How the floor moves, if it moves. */
  readonly shaking: ReadonlySignal<Shaking | undefined>;

  constructor(readonly core: Core) {
    this.simulation = new Simulation(core, this.setup, this);
    // There is always a set-up, and so an outcome.
    this.outcome = this.simulation.outcome as ReadonlySignal<Outcome>;
    ({ motion: this.motion, theory: this.theory, shaking: this.shaking } = this.simulation);
    this.other = new Simulation(core, this.otherSetup, this);
    this.preview = computed(() => {
      const held = this.held.value;
      return held && previewOf(core, this.setup.value, held);
    });
    this.clock = new Clock(this.motion, this.other.motion);
    this.end = computed(() => this.clock.end);
    const shown = (motion: Motion | undefined) => motion?.at([this.clock.time.value]).moment(0);
    this.moment = computed(() => shown(this.motion.value));
    this.otherMoment = computed(() => shown(this.other.motion.value));
    const { time } = this.clock;
    this.turnProgress = computed(() =>
      turnProgressAt(this.motion.value, this.moment.value, time.value),
    );
    this.otherProgress = computed(() =>
      turnProgressAt(this.other.motion.value, this.otherMoment.value, time.value),
    );
    // Compute all flicks once, not again for each one shown.
    const wanted = computed(() => this.flicksShown.value !== undefined);
    const flicks = sliced(() =>
      wanted.value ? flicksOf(core, this.setup.value) : ([] as Flick[]).values(),
    );
    this.flicks = flicks.results;
    this.flicksComplete = flicks.complete;
  }

  /** Changes a part of the set-up and shows the new motion from the release. */
  change(part: Partial<Setup>): void {
    if (this.differs(part)) this.remember();
    this.set({ ...this.setup.value, ...part });
  }

  /** Compares the set-up, after some changes, with another one; undefined ends the comparison. */
  compare(other: Readonly<Setup> | undefined, part: Partial<Setup> = {}): void {
    this.changed = -Infinity;
    if (other !== this.otherSetup.value || this.differs(part)) this.remember();
    this.changed = -Infinity;
    batch(() => {
      this.set({ ...this.setup.value, ...part });
      this.setOther(other);
    });
  }

  /** Goes back to the set-up before the latest change. */
  undo(): void {
    const before = this.before.value.at(-1);
    if (!before) return;
    this.before.value = this.before.value.slice(0, -1);
    this.changed = -Infinity;
    batch(() => {
      this.set(before.setup);
      this.setOther(before.other);
    });
  }

  /** Forgets all earlier set-ups, so that nothing before this one can be restored. */
  beginHere(): void {
    this.before.value = [];
    this.changed = -Infinity;
  }

  /** Keeps the set-up for {@link undo}, but only one for changes that follow each other quickly, as a slider's do. */
  private remember(): void {
    const now = performance.now();
    const before = { setup: this.setup.value, other: this.otherSetup.value };
    if (now - this.changed > UNDO_PAUSE)
      this.before.value = [...this.before.value.slice(1 - MAX_UNDO), before];
    this.changed = now;
  }

  private differs(part: Partial<Setup>): boolean {
    const now: Partial<Setup> = this.setup.value;
    return Object.entries(part).some(([name, value]) => now[name as keyof Setup] !== value);
  }

  private setOther(other: Readonly<Setup> | undefined): void {
    if (other === this.otherSetup.value) return;
    this.clock.pause();
    this.clock.rewind();
    this.otherSetup.value = other;
  }

  private set(setup: Readonly<Setup>): void {
    batch(() => {
      if (withoutFlicks(setup) !== withoutFlicks(this.setup.value)) {
        this.clock.pause();
        this.clock.rewind();
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

  /** Computes the remaining steps of the motions now, if only the first have been computed. */
  complete(): void {
    this.simulation.complete();
    this.other.complete();
  }

  /** Does something when all steps of the motions have been computed, unless the set-ups change before. */
  whenComplete(then: () => void): void {
    this.simulation.whenComplete(() => this.other.whenComplete(then));
  }
}

/** The turn at a time (s), at which the motion has a moment. */
function turnProgressAt(
  motion: Motion | undefined,
  moment: Moment | undefined,
  time: number,
): TurnProgress | undefined {
  if (!motion || !moment) return undefined;
  const turn = motion.turns.find((turn) => time <= turn.end);
  const previous = motion.turns.findLast((turn) => turn.end <= time);
  const start = turn?.start ?? previous?.end ?? 0;
  const first = motion.at([start]).moment(0);
  const bodyAngle = headingOf(moment) - headingOf(first);
  return { angle: moment.yaw - first.yaw, bodyAngle, start, startYaw: first.yaw, turn };
}
