// The clock: the time at which a motion is shown, in the visitor's seconds and the motion's.

import { signal } from "@preact/signals-core";
import { beforeAll, describe, expect, test } from "vitest";
import { Clock, MAX_CONTACT_RATE } from "../../src/clock";
import type { Core } from "../../src/core/core";
import type { Motion } from "../../src/core/motion";
import type { Setup } from "../../src/setup/setup";
import { loadCore, motionOf as motionFrom } from "../given/core";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

const motionOf = (changes?: Partial<Setup>) => motionFrom(core, changes);

const clockOf = (motion: Motion) => new Clock(signal<Motion | undefined>(motion));

describe("in real time, unstretched", () => {
  test("a second of the visitor's is a second of the motion's", () => {
    const clock = clockOf(motionOf());
    clock.stretched.value = false;
    clock.advance(1);
    expect(clock.time.value).toBeCloseTo(1, 12);
    expect(clock.slowdown).toBeCloseTo(1, 9);
    expect(clock.progress).toBeCloseTo(1 / 3, 12);
  });

  test("a ten-thousandth of the speed shows a ten-thousandth of the motion", () => {
    const clock = clockOf(motionOf());
    clock.stretched.value = false;
    clock.speed.value = 1e-4;
    clock.advance(2);
    expect(clock.time.value).toBeCloseTo(2e-4, 15);
    expect(clock.slowdown).toBeCloseTo(1e4, 5);
  });
});

/** Plays until the clock stops, with a limit. */
function playOut(clock: Clock): void {
  for (let k = 0; k < 100_000 && clock.playing.value; k++) clock.advance(0.01);
}

test("a clock that plays up to a time stops exactly there, and continues when played again", () => {
  const clock = clockOf(motionOf());
  clock.play(0.3);
  playOut(clock);
  expect([clock.time.value, clock.playing.value]).toEqual([0.3, false]);
  clock.play();
  clock.advance(0.01);
  expect(clock.time.value).toBeGreaterThan(0.3);
  expect(clock.playing.value).toBe(true);
});

test("a step discards the time at which playing was to stop", () => {
  const clock = clockOf(motionOf());
  clock.play(0.3);
  clock.step(1);
  clock.play();
  playOut(clock);
  expect(clock.time.value).toBe(clock.end);
});

describe("stretched", () => {
  test("no frame turns the contact point faster than the limit", () => {
    const motion = motionOf();
    const clock = clockOf(motion);
    const picture = 1 / 60;
    let most = 0;
    for (let yaw = 0; clock.time.value < motion.end;) {
      clock.advance(picture);
      const now = motion.at([clock.time.value]).moment(0).yaw;
      most = Math.max(most, Math.abs(now - yaw));
      yaw = now;
    }
    // Between the knots of the schedule the yaw bends a little.
    expect(most).toBeLessThan(MAX_CONTACT_RATE * picture * 1.05);
    expect(most).toBeGreaterThan(MAX_CONTACT_RATE * picture * 0.95);
  });

  test("in the middle of a collision the slowdown is the yaw rate over the limit", () => {
    const motion = motionOf();
    const clock = clockOf(motion);
    const turn = motion.turns[0]!;
    clock.time.value = turn.t;
    const slowdown = Math.abs(turn.yawRate) / MAX_CONTACT_RATE;
    expect(clock.slowdown / slowdown).toBeGreaterThan(0.9);
    expect(clock.slowdown / slowdown).toBeLessThan(1.01);
    // Half as fast is twice as slow.
    const before = clock.slowdown;
    clock.speed.value = 0.5;
    expect(clock.slowdown).toBeCloseTo(2 * before, 3);
  });

  test("time is real at the release and at the end", () => {
    const motion = motionOf({ duration: 0.3528 });
    const clock = clockOf(motion);
    expect(clock.slowdown).toBeCloseTo(1, 9);
    clock.time.value = motion.end;
    expect(clock.slowdown).toBeCloseTo(1, 9);
  });

  test("the slowdown is finite and at least 1 even where impacts accumulate", () => {
    const motion = motionOf({ tilt_rate: -3, sideways: 0.1, friction: 0.1, restitution: 0.5 });
    const clock = clockOf(motion);
    for (const event of motion.events) {
      clock.time.value = event.moment.t;
      expect(clock.slowdown).toBeGreaterThan(0.999999);
      expect(clock.slowdown).toBeLessThan(1e9);
    }
  });
});

describe("scrubbing", () => {
  test("sets the time and reads the same progress back", () => {
    const clock = clockOf(motionOf());
    for (const part of [0, 0.05, 0.0532, 0.5, 0.999, 1]) {
      clock.progress = part;
      expect(clock.progress).toBeCloseTo(part, 9);
      expect(clock.progressAt(clock.time.value)).toBe(clock.progress);
    }
    expect(clock.time.value).toBe(clock.end);
  });

  test("a step back undoes a step forward, and pauses", () => {
    const clock = clockOf(motionOf());
    clock.play();
    clock.progress = 0.05;
    const before = clock.time.value;
    clock.step(1);
    expect(clock.playing.value).toBe(false);
    expect(clock.time.value).toBeGreaterThan(before);
    clock.step(-1);
    expect(clock.time.value).toBeCloseTo(before, 12);
  });
});

describe("the ends", () => {
  test("the clock stops at the end, and then plays from the release", () => {
    const clock = clockOf(motionOf());
    clock.play();
    clock.advance(1e6);
    expect(clock.playing.value).toBe(false);
    expect(clock.time.value).toBe(clock.end);
    clock.play();
    expect(clock.time.value).toBe(0);
  });

  test("the clock does not go back before the release", () => {
    const clock = clockOf(motionOf());
    clock.advance(-1);
    expect(clock.time.value).toBe(0);
  });

  test("without a motion the clock stands still", () => {
    const clock = new Clock(signal<Motion | undefined>(undefined));
    clock.advance(1);
    clock.progress = 0.5;
    expect([clock.time.value, clock.end, clock.progress, clock.slowdown]).toEqual([0, 0, 0, 1]);
  });
});

test("the contact point runs evenly, however many steps a motion has", () => {
  const motion = motionOf({ body: "coin" });
  const clock = clockOf(motion);
  const picture = 1 / 60;
  clock.progress = 0.5;
  let before = motion.at([clock.time.value]).moment(0);
  for (let k = 0; k < 200; k++) {
    clock.advance(picture);
    const now = motion.at([clock.time.value]).moment(0);
    const [turned, passed] = [Math.abs(now.yaw - before.yaw), now.t - before.t];
    expect(turned).toBeLessThan(MAX_CONTACT_RATE * picture * 1.05);
    // Where the motion is slow, time is real during a frame or a part of it.
    expect(turned + MAX_CONTACT_RATE * passed).toBeGreaterThan(MAX_CONTACT_RATE * picture * 0.95);
    before = now;
  }
});
