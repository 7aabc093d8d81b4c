// A scene of the essay as a figure of the page: the place of the picture, the button that lets go, one control, and
// what is said of the motion. All scenes share one lab; the one in view has it.

import { batch, effect, type Signal, signal } from "@preact/signals-core";
import { button, element } from "../elements";
import { clearFlicks } from "../falls/shown";
import type { Lab } from "../lab";
import { LAB } from "../part";
import { INITIAL, type Setup } from "../setup/setup";
import { toHash } from "../setup/url";
import { frameField } from "../share/links";
import { soundButton } from "../sound/button";
import { prefersReducedMotion } from "../timing";
import { passageFrom } from "../verdict/passage";
import { words } from "../words/words";
import { type Kind, kindOf } from "./kinds";
import { type Facts, factsOf, type Scene } from "./scenes";

export class Figure {
  readonly id: string;
  /** Where the picture is while the scene is in view. */
  readonly place = element("div", { class: "place" });
  /** What it showed when it was last in view. */
  readonly still = element("canvas", { class: "still", "aria-hidden": "true" });
  hasStill = false;
  private readonly active: Signal<boolean> = signal(false);
  private readonly kind: Kind;
  private time: number | undefined;
  private hasPlayed = false;

  constructor(
    private readonly lab: Lab,
    private readonly scene: Scene,
    root: HTMLElement,
  ) {
    const { active } = this;
    this.id = scene.id;
    const [turnEnd, changed] = [() => this.turnEnd, () => this.changed()];
    this.kind = kindOf({ lab, scene, root, active, turnEnd, changed });
    const { below, control, go, hasSound, isAnnounced } = this.kind;
    const result = element("p", { class: "result", ...(isAnnounced && { role: "status" }) });
    const letGo = button(go, () => this.letGo(), { class: "primary go" });
    this.place.append(this.still, ...(hasSound ? [soundButton(lab, () => active.value)] : []));
    root.replaceChildren(
      this.place,
      element("div", { class: "hands" }, letGo, control),
      result,
      ...below,
      this.linkToLab(),
      frameField(
        `${this.id}-frame`,
        root.getAttribute("aria-label") ?? "",
        () => `embed/${this.id}`,
      ),
    );
    effect(() => {
      if (!active.value) return;
      const text = this.kind.says(this.facts());
      // An unchanged text must not be read out again.
      if (result.textContent !== text) result.textContent = text;
    });
  }

  get graspable(): boolean {
    return this.kind.isGraspable;
  }

  /** Makes the lab show this scene. */
  enter(inView: boolean): void {
    const { kind, lab, scene } = this;
    const { clock } = lab;
    batch(() => {
      clearFlicks(lab);
      lab.held.value = undefined;
      lab.change(this.setup);
      lab.beginHere();
      lab.setPlayback(scene.playback);
      clock.pause();
      lab.marks.value = kind.marks();
    });
    lab.complete();
    const still = prefersReducedMotion();
    clock.time.value = this.time ?? (kind.showsRelease(still) ? 0 : this.turnEnd);
    kind.enter();
    this.active.value = true;
    if (!inView || this.hasPlayed) return;
    this.hasPlayed = true;
    if (!still) kind.begin(() => this.play());
  }

  /** Gives the lab back. */
  leave(): void {
    const { clock } = this.lab;
    this.active.value = false;
    this.time = clock.time.value;
    clock.pause();
  }

  private get setup(): Setup {
    return { ...INITIAL, ...this.scene.setup, ...this.kind.setup() };
  }

  private get turnEnd(): number {
    return this.lab.motion.value?.turns[0]?.end ?? this.lab.clock.end;
  }

  private letGo(): void {
    this.kind.letGo();
    this.lab.complete();
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
    const { kind, lab } = this;
    const { clock } = lab;
    batch(() => {
      lab.change(kind.setup());
      clock.pause();
    });
    lab.complete();
    clock.time.value = this.turnEnd;
    kind.moved();
  }

  private facts(): Facts | undefined {
    const outcome = this.lab.outcome.value;
    if (!("motion" in outcome)) return undefined;
    const passage = passageFrom(outcome.motion, 0);
    const setup = this.lab.setup.value;
    return passage && factsOf(passage, outcome.theory, setup, this.kind.guess);
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
