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
import { reasonFrom } from "./core/reason";
import { type Flicked, flicked } from "./falls/flicked";
import { type Foreseen, foreseen } from "./falls/foreseen";
import { type Posed, posed } from "./setup/posed";
import { FLICK_FIELDS } from "./setup/fields";
import type { Held } from "./setup/released";
import { INITIAL, type Refusal, type Setup } from "./setup/setup";

/** What came of a set-up: a motion, or the reason why there is none. */
export type Outcome = Moves | { refused: string };

export interface Moves {
  posed: Posed;
  motion: Motion;
  theory: Theory;
  /** Whether the motion is only the beginning of what was asked for; see {@link Lab.complete}. */
  begun: boolean;
}

/** A slider waits for so many steps of a motion, some ms. */
const AT_ONCE = 2000;
/** The rest of a longer one is computed when nothing has changed for so long, ms. */
const REST = 250;

/** The angle of turn as far as it has come: rad, from the time (s) at which it begins. */
export interface Turning {
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
export const ownBeside = ({ angle, own, whole }: Turning): number =>
  own * (Math.sign(whole?.angle ?? angle) || 1);

export class Lab {
  readonly setup: Signal<Readonly<Setup>> = signal(INITIAL);
  /** What was refused last, field by field. */
  readonly refusals: Signal<readonly Refusal[]> = signal([]);
  /** The body in a visitor's hand; while it is held nothing moves. */
  readonly held: Signal<Held | undefined> = signal(undefined);
  /** What would become of it there, if the hand let go. */
  readonly foreseen: ReadonlySignal<Foreseen | undefined>;
  /** How many of the repeated flicks are shown; undefined while none were asked for. */
  readonly flicksMade: Signal<number | undefined> = signal(undefined);
  /** Whether more of them are on their way. */
  readonly making: Signal<boolean> = signal(false);
  /** What becomes of all of them, those not made yet included. */
  readonly flicks: ReadonlySignal<readonly Flicked[]>;
  readonly outcome: ReadonlySignal<Outcome>;
  /** Whether all of the motion is wanted now, however long that takes. */
  private readonly whole: Signal<boolean> = signal(false);
  readonly motion: ReadonlySignal<Motion | undefined>;
  readonly theory: ReadonlySignal<Theory | undefined>;
  readonly clock: Clock;
  /** The motion at the time shown. */
  readonly moment: ReadonlySignal<Moment | undefined>;
  readonly turning: ReadonlySignal<Turning | undefined>;

  constructor(readonly core: Core) {
    const release = computed(() => withoutFlicks(this.setup.value));
    this.outcome = computed(() => {
      const most = this.whole.value ? Infinity : AT_ONCE;
      return outcomeOf(core, JSON.parse(release.value) as Setup, most);
    });
    this.motion = computed(() =>
      "motion" in this.outcome.value ? this.outcome.value.motion : undefined,
    );
    this.theory = computed(() =>
      "theory" in this.outcome.value ? this.outcome.value.theory : undefined,
    );
    this.foreseen = computed(() => {
      const held = this.held.value;
      return held && foreseen(core, this.setup.value, held);
    });
    this.clock = new Clock(this.motion);
    this.moment = computed(() => this.motion.value?.at([this.clock.time.value]).moment(0));
    this.turning = computed(() => this.turningAt(this.clock.time.value));
    // Computed once, not anew for each that is shown.
    const asked = computed(() => this.flicksMade.value !== undefined);
    this.flicks = computed(() => (asked.value ? flicked(core, this.setup.value) : []));
    effect(() => {
      if (!hasOnlyBegun(this.outcome.value)) return undefined;
      const resting = setTimeout(() => this.complete(), REST);
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
        this.whole.value = false;
      }
      // Of fewer flicks no more can have been made.
      if ((this.flicksMade.value ?? 0) > setup.flicks) this.flicksMade.value = setup.flicks;
      this.setup.value = setup;
    });
  }

  /** Computes the rest of a motion of which there is only the beginning. */
  complete(): void {
    if (hasOnlyBegun(this.outcome.peek())) this.whole.value = true;
  }

  private turningAt(time: number): Turning | undefined {
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

const hasOnlyBegun = (outcome: Outcome) => "motion" in outcome && outcome.begun;

/** Of the motion no more than so many steps. */
function outcomeOf(core: Core, setup: Readonly<Setup>, most: number): Outcome {
  try {
    const all = posed(core, setup);
    const { body, start, surface, options } = all;
    const maxSteps = Math.min(most, options.maxSteps);
    const motion = core.simulate(body, start, surface, { ...options, maxSteps });
    try {
      const theory = core.theory(body, start, surface, options.gravity);
      const begun = maxSteps < options.maxSteps && motion.isStopped;
      return { posed: all, motion, theory, begun };
    } catch (error) {
      motion.forget();
      throw error;
    }
  } catch (error) {
    return { refused: reasonFrom(error) };
  }
}
