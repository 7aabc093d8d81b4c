// What a visitor sets, on its way to the lab: moves of a slider are gathered so that at most one
// motion is computed a picture, and what cannot be is refused at its field.

import { batch } from "@preact/signals-core";
import type { Lab } from "../lab";
import type { FieldName } from "../setup/fields";
import { INITIAL_PACE } from "../setup/pace";
import { INITIAL, type Setup, read } from "../setup/setup";

export class Hand {
  private gathered: Partial<Record<FieldName, string | number>> = {};
  private picture = 0;

  constructor(readonly lab: Lab) {}

  /** Sets a value that is known to be good, with the next picture. */
  set(name: FieldName, value: string | number): void {
    this.gathered[name] = value;
    this.accept(name);
    this.picture ||= requestAnimationFrame(() => this.give());
  }

  /** Sets what was typed, or says at the field why not. */
  type(name: FieldName, text: string): void {
    const result = read(name, text);
    if ("value" in result) {
      this.set(name, result.value);
    } else {
      const others = this.lab.refusals.value.filter(({ field }) => field !== name);
      this.lab.refusals.value = [...others, result];
    }
  }

  /** Everything as it was at the first visit. */
  reset(): void {
    this.gathered = { ...INITIAL };
    batch(() => {
      this.lab.refusals.value = [];
      this.lab.clock.setPace(INITIAL_PACE);
      this.give();
    });
  }

  /** From the beginning, with all that has been set. */
  letGo(): void {
    this.give();
    // Not while it is watched.
    this.lab.complete();
    this.lab.clock.rewind();
    this.lab.clock.play();
  }

  private accept(name: FieldName): void {
    const { refusals } = this.lab;
    if (refusals.value.some(({ field }) => field === name))
      refusals.value = refusals.value.filter(({ field }) => field !== name);
  }

  private give(): void {
    cancelAnimationFrame(this.picture);
    this.picture = 0;
    const part = this.gathered as Partial<Setup>;
    this.gathered = {};
    if (Object.keys(part).length === 0) return;
    const playing = this.lab.clock.playing.value;
    this.lab.change(part);
    // Whoever watches goes on watching, from the beginning.
    if (playing) this.lab.clock.play();
  }
}
