// Passes the visitor's settings to the lab. Moves of a slider are gathered, so that at most one motion is
// computed per frame, and impossible values are refused at their fields.

import { batch } from "@preact/signals-core";
import type { Lab } from "../lab";
import type { FieldName } from "../setup/fields";
import { INITIAL_PLAYBACK } from "../setup/playback";
import { BY_HAND, readTyped, type Setup } from "../setup/setup";

export class SetupForm {
  private pending: Partial<Record<FieldName, string | number>> = {};
  private frame = 0;

  constructor(readonly lab: Lab) {}

  /** Sets a value that is known to be valid, in the next frame. */
  set(name: FieldName, value: string | number): void {
    this.pending[name] = value;
    this.clearRefusal(name);
    this.frame ||= requestAnimationFrame(() => this.flush());
  }

  /** Sets the value that was typed, or shows at the field why it is refused. */
  type(name: FieldName, text: string): void {
    const result = readTyped(name, text);
    if ("value" in result) {
      this.set(name, result.value);
    } else {
      const others = this.lab.refusals.value.filter(({ field }) => field !== name);
      this.lab.refusals.value = [...others, result];
    }
  }

  /** Restores what the lab opens with, and ends a comparison. */
  reset(): void {
    this.pending = { ...BY_HAND };
    batch(() => {
      this.lab.refusals.value = [];
      this.lab.setPlayback(INITIAL_PLAYBACK);
      this.flush((part) => this.lab.compare(undefined, part));
    });
  }

  /** Takes the latest change back. */
  undo(): void {
    this.flush();
    this.lab.undo();
  }

  /** Plays the motion from the release, with everything that has been set. */
  letGo(): void {
    this.flush();
    this.lab.clock.rewind();
    this.lab.whenComplete(() => this.lab.clock.play());
  }

  private clearRefusal(name: FieldName): void {
    const { refusals } = this.lab;
    if (refusals.value.some(({ field }) => field === name))
      refusals.value = refusals.value.filter(({ field }) => field !== name);
  }

  private flush(apply = (part: Partial<Setup>) => this.lab.change(part)): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const part = this.pending as Partial<Setup>;
    this.pending = {};
    if (Object.keys(part).length === 0) return;
    const playing = this.lab.clock.playing.value;
    apply(part);
    // A motion that was playing plays again from the release.
    if (playing) this.lab.clock.play();
  }
}
