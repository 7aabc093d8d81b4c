// Plays the sound of the motion while it plays, as slow as the film. Parts of the sound are made a little ahead of the film.

import { effect } from "@preact/signals-core";
import type { Lab } from "../lab";

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

// The sound of a contact point that runs round a rim with bumps: each bump that it passes makes a click, and the click is the
// louder the larger the force. Slow clicks are a rattle; many a second are a whirr, whose pitch rises with the speed of the contact.

/** Bumps on the rim, about as many as marks in the picture. */
export const BUMPS = 24;

/** Frequency of the ring after a click, Hz, and the time in which it decays to 1/e, s. They are chosen: a rigid body does not ring. */
const [RING, DECAY] = [1700, 0.004];

/** Loudness of a click at a force of one weight, of which full scale is 1. */
const SOFTEST = 0.06;

/** The contact at some moments that are evenly spaced in the visitor's time. */
export interface Contact {
  /** Angle that the contact point has run round, rad. */
  angles: ArrayLike<number>;
  /** Normal force over the weight. */
  forces: ArrayLike<number>;
}

/** The last two samples of the ring, from which the next part goes on. */
export type Ring = readonly [number, number];

export const SILENT: Ring = [0, 0];

/** Loudness of a click at a force in weights: it grows with the square root, so that the range of forces, 1 to 10 000, can be heard. */
export const loudness = (force: number): number => SOFTEST * Math.sqrt(Math.max(force, 0));

/** Clicks of a contact in `count` samples: the sum of the loudnesses at each sample. Where several bumps are passed in one sample,
 * their energies add up. */
export function clicks({ angles, forces }: Contact, count: number): Float32Array {
  const impulses = new Float32Array(count);
  const last = angles.length - 1;
  const at = (list: ArrayLike<number>, place: number) => {
    const low = Math.min(Math.floor(place), last - 1);
    const [from, to] = [list[low] as number, list[low + 1] as number];
    return from + (place - low) * (to - from);
  };
  const bumpAt = (sample: number) =>
    Math.floor((BUMPS * at(angles, (last * sample) / count)) / (2 * Math.PI));
  let bump = bumpAt(0);
  for (let sample = 0; sample < count; sample++) {
    const next = bumpAt(sample + 1);
    const passed = Math.abs(next - bump);
    bump = next;
    if (passed > 0)
      impulses[sample] = Math.sqrt(passed) * loudness(at(forces, (last * sample) / count));
  }
  return impulses;
}

/** Samples of the sound of a contact, between −1 and 1, at a number of samples a second, and the ring at their end. */
export function synthesize(
  contact: Contact,
  count: number,
  rate: number,
  ring: Ring = SILENT,
): { samples: Float32Array; ring: Ring } {
  const samples = clicks(contact, count);
  const decay = Math.exp(-1 / (DECAY * rate));
  const turn = (2 * Math.PI * RING) / rate;
  const [a, b, gain] = [2 * decay * Math.cos(turn), -decay * decay, Math.sin(turn)];
  let [one, two] = ring;
  for (let k = 0; k < count; k++) {
    const now = a * one + b * two + gain * (samples[k] as number);
    [two, one] = [one, now];
    samples[k] = Math.tanh(now);
  }
  return { samples, ring: [one, two] };
}
