// The kinds of scenes: each has its control, what is shown below the result, and how the motion is played and described.

import { effect, type ReadonlySignal, signal } from "@preact/signals-core";
import { element } from "../elements";
import { fitted } from "../falls/fit";
import { fallsOf } from "../falls/humps";
import { flickSummary, startFlicks } from "../falls/shown";
import { MEASURED } from "../falls/tally";
import { formatFixed } from "../format";
import type { Lab, Marks } from "../lab";
import { entryOf, limitsOf } from "../limits/limits";
import { telephoneButton } from "../scene/telephone";
import { INITIAL, type Setup } from "../setup/setup";
import { passageFrom } from "../verdict/passage";
import { say, words } from "../words/words";
import { choice, field, slider, valuesOf } from "./control";
import { computeLines, Curve, POINTS } from "./curve";
import { type Choice, type Facts, guessInWords, type Quantity, type Scene } from "./scenes";

/** What a kind knows of its figure. */
export interface Stand {
  lab: Lab;
  scene: Scene;
  /** The figure on the page. */
  root: HTMLElement;
  /** Whether the scene is in view, so that it has the lab. */
  active: ReadonlySignal<boolean>;
  /** End of the first turn, s. */
  turnEnd(): number;
  /** Shows what the control has set. */
  changed(): void;
}

export abstract class Kind {
  abstract readonly control: HTMLElement;
  /** What is shown below the result. */
  readonly below: readonly HTMLElement[] = [];
  /** Whether the visitor can tip the body. */
  readonly isGraspable: boolean = false;
  /** Whether screen readers read the result when it changes. */
  readonly isAnnounced: boolean = false;
  /** Whether the scene shows one motion, which can be heard. */
  readonly hasSound: boolean = true;
  /** What the button says. */
  readonly go: string = words.letGo;

  constructor(protected readonly stand: Stand) {}

  /** The part of the set-up that the control chooses. */
  setup(): Partial<Setup> {
    return {};
  }

  /** What the picture marks. */
  marks(): Marks {
    return { theory: false, guess: undefined };
  }

  /** The guess, rad. */
  get guess(): number {
    return Math.PI;
  }

  /** What the scene says of its motion; empty while it says nothing. */
  says(facts: Facts | undefined): string {
    return facts ? this.stand.scene.says(facts) : "";
  }

  /** Whether the scene shows the release when it first comes into view, and not the end of the turn. */
  showsRelease(still: boolean): boolean {
    return this.stand.scene.plays === true && !still;
  }

  /** Plays when the scene first comes into view. */
  begin(play: () => void): void {
    if (this.stand.scene.plays) play();
  }

  /** The lab shows the scene again. */
  enter(): void {}

  letGo(): void {}

  /** The control has changed. */
  moved(): void {}
}

/** The kind of a scene. */
export function kindOf(stand: Stand): Kind {
  const { control, flicks, limits } = stand.scene;
  switch (control.kind) {
    case "guess":
      return new Guess(stand);
    case "time":
      return new Time(stand);
    case "grasp":
      return new Grasp(stand);
    case "choice":
      return new Chosen(stand, control);
    case "quantity":
      if (flicks) return new Flicked(stand, control);
      return limits ? new Limited(stand, control) : new Varied(stand, control);
  }
}

/** The first fall stops at this part of the time to the smallest tilt. */
const NEARLY = 0.9;

/** The visitor guesses where the body comes up, and then sees it. */
class Guess extends Kind {
  readonly control: HTMLElement;
  override readonly below = [closer()];
  override readonly isAnnounced = true;
  private readonly degrees = signal(180);
  /** Whether the visitor has seen where the body comes up. */
  private readonly answered = signal(false);

  constructor(stand: Stand) {
    super(stand);
    const { active, lab, root, scene } = stand;
    const bounds = { min: 90, max: 270, step: 1, value: 180 };
    const { root: control, input, write } = field(scene.id, words.essay.guess, bounds);
    this.control = control;
    input.addEventListener("input", () => {
      this.degrees.value = Number(input.value);
      this.answered.value = false;
      lab.marks.value = this.marks();
    });
    effect(() => write(guessInWords(this.degrees.value)));
    effect(() => {
      const { playing, time } = lab.clock;
      if (!active.value || playing.value) return;
      if (time.value > 0 && time.value >= stand.turnEnd()) this.answered.value = true;
    });
    effect(() => {
      root.classList.toggle("answered", this.answered.value);
    });
  }

  override get guess(): number {
    return (this.degrees.value * Math.PI) / 180;
  }

  override marks(): Marks {
    return { theory: false, guess: this.guess };
  }

  override says(facts: Facts | undefined): string {
    return this.answered.value ? super.says(facts) : "";
  }

  override showsRelease(): boolean {
    return true;
  }

  override begin(): void {
    const { clock, motion } = this.stand.lab;
    clock.play(NEARLY * (motion.value?.turns[0]?.t ?? 0));
  }

  override letGo(): void {
    this.answered.value = false;
  }
}

/** The way to the explanation, shown with the answer. */
const closer = () =>
  element("p", { class: "closer" }, element("a", { href: "#slap-or-roll" }, words.essay.closer));

/** Steps of the slider for the time. */
const MOMENTS = 1000;

/** The visitor goes to any time of the turn. */
class Time extends Kind {
  readonly control: HTMLElement;

  constructor(stand: Stand) {
    super(stand);
    const { active, lab, scene } = stand;
    const { clock } = lab;
    const bounds = { min: 0, max: MOMENTS, step: 1, value: 0 };
    const { root, input, write } = field(scene.id, words.essay.time, bounds);
    this.control = root;
    const whole = () => clock.progressAt(stand.turnEnd()) || 1;
    input.addEventListener("input", () => {
      clock.pause();
      clock.progress = (whole() * Number(input.value)) / MOMENTS;
    });
    effect(() => {
      if (!active.value) return;
      const since = clock.time.value - (lab.motion.value?.turns[0]?.t ?? 0);
      input.value = String(Math.round((MOMENTS * clock.progress) / whole()));
      write(momentInWords(since));
    });
  }
}

/** A time (s) from the smallest tilt, in words. */
function momentInWords(since: number): string {
  const size = Math.abs(since);
  const time =
    size < 1e-3
      ? `${formatFixed(size * 1e6, 0)} µs`
      : `${formatFixed(size * 1e3, size < 0.01 ? 1 : 0)} ms`;
  if (size < 5e-7) return words.essay.atSmallest;
  return say(words.essay.fromSmallest, { time, when: since < 0 ? "before" : "after" });
}

/** The visitor tips the body. */
class Grasp extends Kind {
  override readonly isGraspable = true;
  readonly control: HTMLElement;

  constructor(stand: Stand) {
    super(stand);
    const hint = element("p", { class: "hint" }, words.essay.grasp);
    this.control = element("div", {}, hint, telephoneButton(stand.lab, stand.active));
  }
}

/** The visitor chooses among set-ups. */
class Chosen extends Kind {
  readonly control: HTMLElement;
  override readonly setup: () => Partial<Setup>;

  constructor(stand: Stand, options: Choice) {
    super(stand);
    ({ root: this.control, setup: this.setup } = choice(options, () => stand.changed()));
  }

  override marks(): Marks {
    return { theory: true, guess: undefined };
  }
}

/** The visitor varies a quantity. A plot, if the scene has one, is computed when it first comes into view. */
class Varied extends Kind {
  readonly control: HTMLElement;
  override setup: () => Partial<Setup>;
  override readonly below: readonly HTMLElement[];
  private readonly part: () => number;
  private curve: Curve | undefined;

  constructor(
    stand: Stand,
    private readonly quantity: Quantity,
  ) {
    super(stand);
    const { active, scene } = stand;
    ({
      root: this.control,
      setup: this.setup,
      part: this.part,
    } = slider(quantity, scene.id, () => stand.changed()));
    const place = element("div", { class: "plot-place" });
    this.below = scene.curve ? [place] : [];
    effect(() => {
      if (!active.value || this.curve || !scene.curve) return;
      this.curve = this.plotted();
      this.curve.mark(this.part());
      place.append(this.curve.root);
    });
  }

  override marks(): Marks {
    return { theory: this.stand.scene.curve !== undefined, guess: undefined };
  }

  override moved(): void {
    this.curve?.mark(this.part());
  }

  private plotted(): Curve {
    const { quantity, stand } = this;
    const { curve = [], include, setup } = stand.scene;
    const values = valuesOf(quantity, POINTS);
    const setups = values.map((value) => ({ ...setup, ...quantity.setup(value) }));
    const [from, to] = [quantity.words(quantity.low), quantity.words(quantity.high)];
    return new Curve(
      computeLines(stand.lab.core, curve, setups),
      say(words.essay.range, { label: quantity.label, from, to }),
      include,
    );
  }
}

/** The release is repeated, and all falls are shown. */
class Flicked extends Varied {
  override readonly isAnnounced = true;
  override readonly hasSound = false;
  override readonly go = say(words.flickTimes, { count: INITIAL.flicks });
  override readonly below: readonly HTMLElement[];
  private flicked = false;
  /** Of the flicks that are shown. */
  private seed = INITIAL.seed;

  constructor(stand: Stand, quantity: Quantity) {
    super(stand, quantity);
    const { active, lab, scene } = stand;
    const falls = fallsOf(lab, () => active.value);
    falls.append(
      fitted(
        lab.core,
        () => ({ ...INITIAL, ...scene.setup }),
        () => MEASURED,
      ),
    );
    this.below = [falls];
    const { setup } = this;
    this.setup = () => ({ ...setup(), seed: this.seed });
  }

  override says(): string {
    return flickSummary(this.stand.lab);
  }

  override enter(): void {
    const { lab } = this.stand;
    if (this.flicked) lab.flicksShown.value = lab.setup.value.flicks;
  }

  override letGo(): void {
    const { lab } = this.stand;
    if (this.flicked) lab.change({ seed: ++this.seed });
    this.flicked = true;
    startFlicks(lab);
  }
}

/** The motion is compared with what the model leaves out. */
class Limited extends Varied {
  override readonly below: readonly HTMLElement[];

  constructor(stand: Stand, quantity: Quantity) {
    super(stand, quantity);
    const list = element("dl", { class: "limits" });
    this.below = [list];
    effect(() => {
      const outcome = stand.lab.outcome.value;
      if (!stand.active.value || !("motion" in outcome)) return;
      const passage = passageFrom(outcome.motion, 0);
      list.replaceChildren(...(passage ? limitsOf(passage.validity) : []).map(entryOf));
    });
  }
}
