// A scene of the essay as a figure of the page: the place of the picture, the button that lets go, one control, and
// what is said of the motion. All scenes share one lab; the one in view has it.

import { batch, computed, effect, type Signal, signal } from "@preact/signals-core";
import { button, element, svgElement } from "../elements";
import { clearFlicks, flickSummary, startFlicks } from "../falls/shown";
import { MEASURED, tallyOf } from "../falls/tally";
import { fitted } from "../falls/fit";
import type { Lab } from "../lab";
import { limitsOf } from "../limits/limits";
import { LAB } from "../part";
import { prefersReducedMotion } from "../timing";
import { INITIAL, type Setup } from "../setup/setup";
import { toHash } from "../setup/url";
import { binsFor, HEIGHT, humps, WIDTH } from "../falls/humps";
import { frameField } from "../share/links";
import { telephoneButton } from "../scene/telephone";
import { soundButton } from "../sound/button";
import { passageFrom } from "../verdict/passage";
import { choice, type Control, slider, valuesOf } from "./control";
import { computeLines, Curve, POINTS } from "./curve";
import { type Facts, factsOf, guessInWords, type Scene } from "./scenes";
import { formatFixed } from "../format";
import { say, sentences, words } from "../words/words";

/** The first fall stops at this part of the time to the smallest tilt. */
const NEARLY = 0.9;
/** Steps of the slider for the time. */
const MOMENTS = 1000;

export class Figure {
  readonly id: string;
  /** Where the picture is while the scene is in view. */
  readonly place = element("div", { class: "place" });
  /** What it showed when it was last in view. */
  readonly still = element("canvas", { class: "still", "aria-hidden": "true" });
  hasStill = false;
  readonly graspable: boolean;
  private readonly active: Signal<boolean> = signal(false);
  private readonly guess: Signal<number> = signal(180);
  /** Whether the visitor has seen where the body comes up. */
  private readonly answered: Signal<boolean> = signal(false);
  private readonly control: Control | undefined;
  private readonly result: HTMLElement;
  private time: number | undefined;
  private hasPlayed = false;
  private flicked = false;
  /** Of the flicks that are shown. */
  private seed = INITIAL.seed;
  private curve: Curve | undefined;

  constructor(
    private readonly lab: Lab,
    private readonly scene: Scene,
    private readonly root: HTMLElement,
  ) {
    this.id = scene.id;
    const { control } = scene;
    this.graspable = control.kind === "grasp";
    const changed = () => this.changed();
    if (control.kind === "quantity") this.control = slider(control, this.id, changed);
    if (control.kind === "choice") this.control = choice(control, changed);
    const status = control.kind === "guess" || scene.flicks ? { role: "status" } : {};
    this.result = element("p", { class: "result", ...status });
    const go = button(
      scene.flicks ? say(words.flickTimes, { count: INITIAL.flicks }) : words.letGo,
      () => this.letGo(),
      {
        class: "primary go",
      },
    );
    this.place.append(this.still, ...this.sound());
    root.replaceChildren(
      this.place,
      element("div", { class: "hands" }, go, this.controlElement()),
      this.result,
      ...this.extras(),
      this.linkToLab(),
      frameField(
        `${this.id}-frame`,
        root.getAttribute("aria-label") ?? "",
        () => `embed/${this.id}`,
      ),
    );
    effect(() => {
      if (this.active.value) this.say();
    });
    effect(() => {
      const { playing, time } = lab.clock;
      if (!this.active.value || control.kind !== "guess" || playing.value) return;
      if (time.value > 0 && time.value >= this.turnEnd) this.answered.value = true;
    });
  }

  /** Makes the lab show this scene. */
  enter(inView: boolean): void {
    const { lab, scene } = this;
    const { clock } = lab;
    batch(() => {
      clearFlicks(lab);
      lab.held.value = undefined;
      lab.change(this.setup);
      lab.beginHere();
      lab.setPlayback(scene.playback);
      clock.pause();
      this.mark();
    });
    lab.complete();
    const still = prefersReducedMotion();
    const starts = scene.control.kind === "guess" || (scene.plays && !still);
    clock.time.value = this.time ?? (starts ? 0 : this.turnEnd);
    if (this.flicked) lab.flicksShown.value = lab.setup.value.flicks;
    this.active.value = true;
    if (!inView || this.hasPlayed) return;
    this.hasPlayed = true;
    if (still) return;
    if (scene.control.kind === "guess") clock.play(NEARLY * (lab.motion.value?.turns[0]?.t ?? 0));
    else if (scene.plays) this.play();
  }

  /** Gives the lab back. */
  leave(): void {
    const { clock } = this.lab;
    this.active.value = false;
    this.time = clock.time.value;
    clock.pause();
  }

  private get setup(): Setup {
    return { ...INITIAL, seed: this.seed, ...this.scene.setup, ...this.control?.setup() };
  }

  private get turnEnd(): number {
    return this.lab.motion.value?.turns[0]?.end ?? this.lab.clock.end;
  }

  private letGo(): void {
    const { lab, scene } = this;
    this.answered.value = false;
    if (scene.flicks) {
      if (this.flicked) lab.change({ seed: ++this.seed });
      this.flicked = true;
      startFlicks(lab);
    }
    lab.complete();
    this.play();
  }

  private play(): void {
    const { clock } = this.lab;
    clock.pause();
    clock.rewind();
    clock.play(this.turnEnd);
  }

  /** Shows the end of the turn after a change of the control, so that the place where the body comes up moves with it. */
  private changed(): void {
    const { lab } = this;
    const { clock } = lab;
    batch(() => {
      lab.change({ ...this.control?.setup() });
      clock.pause();
    });
    lab.complete();
    clock.time.value = this.turnEnd;
    this.curve?.mark(this.control?.part() ?? 0);
  }

  private mark(): void {
    const { control, curve } = this.scene;
    const guess = control.kind === "guess" ? (this.guess.value * Math.PI) / 180 : undefined;
    this.lab.marks.value = { theory: curve !== undefined || control.kind === "choice", guess };
  }

  private facts(): Facts | undefined {
    const outcome = this.lab.outcome.value;
    if (!("motion" in outcome)) return undefined;
    const passage = passageFrom(outcome.motion, 0);
    const guess = (this.guess.value * Math.PI) / 180;
    return passage && factsOf(passage, outcome.theory, this.lab.setup.value, guess);
  }

  private say(): void {
    const { scene, lab } = this;
    const facts = this.facts();
    const hidden = scene.control.kind === "guess" && !this.answered.value;
    const text = scene.flicks ? flickSummary(lab) : facts && !hidden ? scene.says(facts) : "";
    // An unchanged text must not be read out again.
    if (this.result.textContent !== text) this.result.textContent = text;
    this.root.classList.toggle("answered", this.answered.value);
  }

  /** The button for the sound of a scene that shows one motion. */
  private sound(): HTMLElement[] {
    return this.scene.flicks ? [] : [soundButton(this.lab, () => this.active.value)];
  }

  private controlElement(): HTMLElement {
    const { kind } = this.scene.control;
    if (this.control) return this.control.root;
    if (kind === "guess") return this.guessElement();
    if (kind === "time") return this.timeElement();
    return element(
      "div",
      {},
      element("p", { class: "hint" }, words.essay.grasp),
      telephoneButton(this.lab, this.active),
    );
  }

  private guessElement(): HTMLElement {
    const input = element("input", {
      type: "range",
      id: `${this.id}-control`,
      min: 90,
      max: 270,
      value: 180,
    });
    const output = element("output", { for: input.id });
    input.addEventListener("input", () => {
      this.guess.value = Number(input.value);
      this.answered.value = false;
      this.mark();
    });
    effect(() => {
      output.textContent = guessInWords(this.guess.value);
      input.setAttribute("aria-valuetext", output.textContent);
    });
    return element(
      "div",
      { class: "control" },
      element("label", { for: input.id }, words.essay.guess),
      output,
      input,
    );
  }

  private timeElement(): HTMLElement {
    const { clock } = this.lab;
    const input = element("input", {
      type: "range",
      id: `${this.id}-control`,
      min: 0,
      max: MOMENTS,
      value: 0,
    });
    const output = element("output", { for: input.id });
    const whole = () => clock.progressAt(this.turnEnd) || 1;
    input.addEventListener("input", () => {
      clock.pause();
      clock.progress = (whole() * Number(input.value)) / MOMENTS;
    });
    effect(() => {
      if (!this.active.value) return;
      const since = clock.time.value - (this.lab.motion.value?.turns[0]?.t ?? 0);
      input.value = String(Math.round((MOMENTS * clock.progress) / whole()));
      output.textContent = momentInWords(since);
      input.setAttribute("aria-valuetext", output.textContent);
    });
    return element(
      "div",
      { class: "control" },
      element("label", { for: input.id }, words.essay.time),
      output,
      input,
    );
  }

  private extras(): (HTMLElement | SVGElement)[] {
    const { scene } = this;
    return [
      ...(scene.control.kind === "guess" ? [closer()] : []),
      ...(scene.curve ? [this.curveElement()] : []),
      ...(scene.flicks ? [this.fallsElement()] : []),
      ...(scene.limits ? [this.limitsElement()] : []),
    ];
  }

  /** The plot is computed when the scene first comes into view. */
  private curveElement(): HTMLElement {
    const { control, curve = [], include, setup } = this.scene;
    const place = element("div", { class: "plot-place" });
    effect(() => {
      if (!this.active.value || this.curve || control.kind !== "quantity") return;
      const setups = valuesOf(control, POINTS).map((value) => ({
        ...setup,
        ...control.setup(value),
      }));
      this.curve = new Curve(
        computeLines(this.lab.core, curve, setups),
        say(words.essay.range, {
          label: control.label,
          from: control.words(control.low),
          to: control.words(control.high),
        }),
        include,
      );
      this.curve.mark(this.control?.part() ?? 0);
      place.append(this.curve.root);
    });
    return place;
  }

  private fallsElement(): HTMLElement {
    const { lab } = this;
    const picture = svgElement("svg", {
      viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
      role: "img",
      "aria-label": words.flicks.title, // until the scene is in view
    });
    const caption = element("p", { class: "caption" });
    const bins = computed(() => {
      const { left, right } = tallyOf(lab.flicks.value);
      return binsFor(lab.theory.value, [...left.turns, ...right.turns]);
    });
    effect(() => {
      if (!this.active.value) return;
      const tally = tallyOf(lab.flicks.value.slice(0, lab.flicksShown.value ?? 0));
      picture.innerHTML = humps({
        tally,
        theory: lab.theory.value,
        bins: bins.value,
        measured: true,
      });
      const { from, to, width } = bins.value;
      picture.setAttribute(
        "aria-label",
        sentences(
          say(words.story.histogram, { from: `${from}°`, to: `${to}°`, width: `${width}°` }),
          flickSummary(lab),
        ),
      );
      caption.textContent = sentences(
        say(words.story.caption, { width: `${width}°` }),
        words.story.measured,
      );
    });
    return element(
      "div",
      { class: "falls" },
      picture as unknown as HTMLElement,
      caption,
      fitted(
        lab.core,
        () => ({ ...INITIAL, ...this.scene.setup }),
        () => MEASURED,
      ),
    );
  }

  private limitsElement(): HTMLElement {
    const list = element("dl", { class: "limits" });
    effect(() => {
      const outcome = this.lab.outcome.value;
      if (!this.active.value || !("motion" in outcome)) return;
      const passage = passageFrom(outcome.motion, 0);
      const limits = passage ? limitsOf(passage.validity) : [];
      list.replaceChildren(
        ...limits.map(({ name, here, means, exceeded }) =>
          element(
            "div",
            { class: exceeded ? "exceeded" : "held" },
            element("dt", {}, name),
            element("dd", { class: "here" }, here),
            element("dd", { class: "means" }, means),
          ),
        ),
      );
    });
    return list;
  }

  private linkToLab(): HTMLElement {
    const link = element("a", { class: "in-lab" }, words.essay.inLab);
    effect(() => {
      void this.lab.setup.value;
      const shown = this.active.value ? this.lab.setup.value : this.setup;
      link.href = `#${toHash(shown, this.scene.playback) || LAB}`;
    });
    return element("p", { class: "to-lab" }, link);
  }
}

/** The way to the explanation, shown with the answer. */
const closer = () =>
  element("p", { class: "closer" }, element("a", { href: "#slap-or-roll" }, words.essay.closer));

/** A time (s) from the smallest tilt, in words. */
function momentInWords(since: number): string {
  const size = Math.abs(since);
  const text =
    size < 1e-3
      ? `${formatFixed(size * 1e6, 0)} µs`
      : `${formatFixed(size * 1e3, size < 0.01 ? 1 : 0)} ms`;
  if (size < 5e-7) return words.essay.atSmallest;
  return say(words.essay.fromSmallest, { time: text, when: since < 0 ? "before" : "after" });
}
