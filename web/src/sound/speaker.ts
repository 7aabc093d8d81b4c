// Plays the sound of the motion while it plays, as slow as the film. Parts of the sound are made a little ahead of the film.

import { effect } from "@preact/signals-core";
import type { Lab } from "../lab";
import { type Ring, SILENT, synthesize } from "./synthesis";

/** Samples of a part. */
const PART = 2048;
/** Moments of the motion for each part. */
const MOMENTS = 48;
/** The sound is made this far ahead, s, and begins this late, so that a slow frame leaves no gap. */
const [AHEAD, DELAY] = [0.2, 0.06];
/** A larger distance between film and sound is made up by a jump of the sound, s. */
const APART = 0.12;

export class Speaker {
  private readonly context = new AudioContext();
  private parts: AudioBufferSourceNode[] = [];
  /** The end of what has been made: in the time of the context, and in the visitor's time of the film. */
  private front: { sounds: number; shown: number } | undefined;
  private ring: Ring = SILENT;
  private readonly end: () => void;

  constructor(private readonly lab: Lab) {
    void this.context.resume();
    this.end = effect(() => {
      void [lab.clock.time.value, lab.clock.speed.value, lab.clock.stretched.value];
      if (lab.clock.playing.value) this.goOn();
      else this.pause();
    });
  }

  close(): void {
    this.end();
    this.pause();
    void this.context.close();
  }

  private pause(): void {
    for (const part of this.parts) part.stop();
    this.parts = [];
    this.front = undefined;
    this.ring = SILENT;
  }

  private goOn(): void {
    const { context, lab } = this;
    const [now, shown] = [context.currentTime, lab.clock.shown];
    const due = this.front && this.front.sounds - now - (this.front.shown - shown) - DELAY;
    if (due === undefined || Math.abs(due) > APART) {
      this.pause();
      this.front = { sounds: now + DELAY, shown };
    }
    while (this.front && this.front.sounds < now + AHEAD) this.front = this.add(this.front);
  }

  /** Adds a part after what has been made. */
  private add({ sounds, shown }: { sounds: number; shown: number }) {
    const { context, lab } = this;
    const length = PART / context.sampleRate;
    const times = Array.from({ length: MOMENTS + 1 }, (_, k) =>
      lab.clock.timeWhen(shown + (length * k) / MOMENTS),
    );
    const outcome = lab.outcome.peek();
    if ("motion" in outcome) {
      const moments = outcome.motion.at(times);
      const { body, options } = outcome.input;
      const weight = body.mass * options.gravity;
      const forces = moments.column("normal_force").map((force) => force / weight);
      const contact = { angles: moments.column("yaw"), forces };
      const { samples, ring } = synthesize(contact, PART, context.sampleRate, this.ring);
      this.ring = ring;
      const buffer = context.createBuffer(1, PART, context.sampleRate);
      buffer.getChannelData(0).set(samples);
      const part = context.createBufferSource();
      part.buffer = buffer;
      part.connect(context.destination);
      part.addEventListener("ended", () => (this.parts = this.parts.filter((one) => one !== part)));
      part.start(sounds);
      this.parts.push(part);
    }
    return { sounds: sounds + length, shown: shown + length };
  }
}
