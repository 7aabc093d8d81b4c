// What a visitor sets, on its way to the lab: moves of a slider are pending so that at most one
// motion is computed a picture, and what cannot be is refused at its field.

import { batch } from "@preact/signals-core";
import type { Lab } from "../lab";
import type { FieldName } from "../setup/fields";
import { INITIAL_PLAYBACK } from "../setup/playback";
import { INITIAL, type Setup, read } from "../setup/setup";

export class SetupForm {
  private pending: Partial<Record<FieldName, string | number>> = {};
  private frame = 0;

  constructor(readonly lab: Lab) {}

  /** Sets a value that is known to be good, with the next picture. */
  set(name: FieldName, value: string | number): void {
    this.pending[name] = value;
    this.clearRefusal(name);
    this.frame ||= requestAnimationFrame(() => this.flush());
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
    this.pending = { ...INITIAL };
    batch(() => {
      this.lab.refusals.value = [];
      this.lab.clock.setPlayback(INITIAL_PLAYBACK);
      this.flush();
    });
  }

  /** From the beginning, with all that has been set. */
  letGo(): void {
    this.flush();
    // Not while it is watched.
    this.lab.complete();
    this.lab.clock.rewind();
    this.lab.clock.play();
  }

  private clearRefusal(name: FieldName): void {
    const { refusals } = this.lab;
    if (refusals.value.some(({ field }) => field === name))
      refusals.value = refusals.value.filter(({ field }) => field !== name);
  }

  private flush(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const part = this.pending as Partial<Setup>;
    this.pending = {};
    if (Object.keys(part).length === 0) return;
    const playing = this.lab.clock.playing.value;
    this.lab.change(part);
    // Whoever watches goes on watching, from the beginning.
    if (playing) this.lab.clock.play();
  }
}
