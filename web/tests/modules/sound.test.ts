// The sound: its pitch follows the speed of the contact point on the screen, its loudness the force.

import { beforeAll, describe, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import { BUMPS, clicks, loudness, synthesize } from "../../src/sound/speaker";
import { loadCore } from "../given/core";
import { labWith } from "../given/page";

const RATE = 48_000;

/** A contact that runs round at a steady rate (1/s) for a time (s), under a steady force in weights. */
const steady = (rounds: number, seconds: number, force = 1) => ({
  angles: [0, 2 * Math.PI * rounds * seconds],
  forces: [force, force],
});

const count = (impulses: Float32Array) => impulses.filter((impulse) => impulse > 0).length;
const size = (samples: Float32Array) =>
  Math.sqrt(samples.reduce((sum, sample) => sum + sample ** 2, 0) / samples.length);

/** The largest component of the envelope of a sound, Hz. */
function pitch(samples: Float32Array): number {
  const envelope = samples.map(Math.abs);
  const strength = (frequency: number) => {
    let [re, im] = [0, 0];
    envelope.forEach((value, k) => {
      const phase = (2 * Math.PI * frequency * k) / RATE;
      re += value * Math.cos(phase);
      im += value * Math.sin(phase);
    });
    return Math.hypot(re, im);
  };
  const frequencies = Array.from({ length: 290 }, (_, k) => 10 + k);
  return frequencies.reduce((best, one) => (strength(one) > strength(best) ? one : best));
}

test.each([0.5, 2, 12, 300])("at %d rounds a second each bump clicks once a round", (rounds) => {
  expect(count(clicks(steady(rounds, 2), 2 * RATE))).toBe(2 * rounds * BUMPS);
});

test.each([2, 5, 10])("the pitch at %d rounds a second is that of the bumps", (rounds) => {
  const { samples } = synthesize(steady(rounds, 0.5), RATE / 2, RATE);
  expect(Math.abs(pitch(samples) - BUMPS * rounds)).toBeLessThanOrEqual(1);
});

test("the other direction sounds the same", () => {
  const { angles, forces } = steady(3, 1);
  const back = { angles: angles.map((angle) => -angle), forces };
  expect(Math.abs(count(clicks(back, RATE)) - 3 * BUMPS)).toBeLessThanOrEqual(1);
});

test("the loudness grows with the square root of the force", () => {
  expect(loudness(4)).toBeCloseTo(2 * loudness(1), 12);
  const sound = (force: number) => size(synthesize(steady(5, 0.5, force), RATE / 2, RATE).samples);
  expect(sound(4) / sound(1)).toBeCloseTo(2, 1);
  expect(sound(0)).toBe(0);
});

test("it never exceeds full scale, and parts go on without a break", () => {
  const contact = { angles: [0, 40, 90], forces: [3, 5000, 5000] };
  const { samples } = synthesize(contact, 4000, RATE);
  expect(Math.max(...samples.map(Math.abs))).toBeLessThanOrEqual(1);
  const first = synthesize({ angles: [0, 40], forces: [3, 5000] }, 2000, RATE);
  const second = synthesize({ angles: [40, 90], forces: [5000, 5000] }, 2000, RATE, first.ring);
  const joined = Float32Array.from([...first.samples, ...second.samples]);
  joined.forEach((sample, k) => expect(sample).toBeCloseTo(samples[k]!, 5));
});

describe("the motion of a can", () => {
  let core: Core;
  beforeAll(async () => {
    core = await loadCore();
  });

  /** Sound of the first fall, as shown at a speed. */
  function sound(speed: number) {
    const lab = labWith(core, { sideways: 0.02 });
    lab.clock.stretched.value = false;
    lab.clock.speed.value = speed;
    const [turn] = lab.motion.value!.turns;
    lab.clock.time.value = turn!.t;
    const middle = lab.clock.shown;
    expect(lab.clock.timeWhen(middle)).toBeCloseTo(turn!.t, 12);
    const times = Array.from({ length: 400 }, (_, k) =>
      lab.clock.timeWhen(middle + ((k - 200) / 200) * 0.05),
    );
    const moments = lab.motion.value!.at(times);
    const outcome = lab.outcome.value;
    if (!("motion" in outcome)) throw new Error(outcome.refused);
    const { body, options } = outcome.input;
    const forces = moments
      .column("normal_force")
      .map((force) => force / (body.mass * options.gravity));
    return clicks({ angles: moments.column("yaw"), forces }, 0.1 * RATE);
  }

  test("is loudest at the smallest gap", () => {
    const heard = sound(0.1);
    const loudest = heard.indexOf(Math.max(...heard));
    expect(Math.abs(loudest - 0.05 * RATE)).toBeLessThan(0.02 * RATE);
  });

  test("that is shown slower has as many clicks a round, fewer a second", () => {
    const [fast, slow] = [count(sound(0.02)), count(sound(0.01))];
    expect(fast).toBeGreaterThan(slow);
    expect(slow).toBeGreaterThan(0);
  });
});
