// Releases by hand, as values of the set-up.

import { expect, test, vi } from "vitest";
import { Lab } from "../../src/lab";
import { Hands } from "../../src/scene/hands";
import { ZERO_RATE, releasedSetup } from "../../src/setup/release";
import { HAND_ERROR, INITIAL } from "../../src/setup/setup";
import { loadCore } from "../given/core";

const DEGREE = Math.PI / 180;

test("a hand at rest releases at rest, except for the sideways error", () => {
  const setup = releasedSetup({ tilt: 0.4, yaw: 0.3 }, ZERO_RATE, { ...INITIAL, sideways: 0.003 });
  expect(setup).toEqual({ tilt: 22.9, yaw: 17.2, tilt_rate: 0, twist: 0, sideways: 0.003 });
});

test("the sideways error of a flick does not carry over to a release at rest", () => {
  const setup = releasedSetup({ tilt: 0.4, yaw: 0 }, ZERO_RATE, { ...INITIAL, sideways: 1.5 });
  expect(setup.sideways).toBe(HAND_ERROR);
});

test("a hand that moves the body toward upright gives a negative tilt rate", () => {
  // With yaw 0 the body leans toward −x.
  const setup = releasedSetup({ tilt: 20 * DEGREE, yaw: 0 }, { x: 2, y: 0 }, INITIAL);
  expect(setup.tilt_rate).toBe(-2);
  expect(setup.sideways).toBe(INITIAL.sideways);
});

test("a lean that is swung round anticlockwise has the yaw rate of the hand", () => {
  const tilt = 20 * DEGREE;
  const setup = releasedSetup({ tilt, yaw: 0 }, { x: 0, y: -0.5 }, INITIAL);
  // yaw rate = sideways · cot(tilt); the hand swings round at its speed over the tilt.
  const yawRate = (setup.sideways as number) / Math.tan(tilt);
  expect(yawRate).toBeCloseTo(0.5 / tilt, 2);
});

test("a direction is between −180 and 180 degrees, whichever way round the hand went", () => {
  expect(releasedSetup({ tilt: 0.4, yaw: 1.5 * Math.PI }, ZERO_RATE, INITIAL).yaw).toBe(-90);
  expect(releasedSetup({ tilt: 0.4, yaw: -3 * Math.PI }, ZERO_RATE, INITIAL).yaw).toBe(-180);
});

test("the rate of a flick is limited", () => {
  const { tilt_rate } = releasedSetup({ tilt: 0.4, yaw: 0 }, { x: -1e4, y: 0 }, INITIAL);
  expect(tilt_rate).toBe(25);
});

test("keys flick a held body with the rates of the sliders", async () => {
  vi.stubGlobal("requestAnimationFrame", () => 0);
  const lab = new Lab(await loadCore());
  lab.change({ tilt_rate: -3, sideways: 0.25, twist: 1 });
  const hands = new Hands(lab);
  hands.flick();
  expect(lab.clock.playing.value).toBe(false);
  hands.take();
  hands.tip(5 * DEGREE);
  hands.flick();
  const { tilt, tilt_rate, sideways, twist } = lab.setup.value;
  expect([tilt, tilt_rate, sideways, twist]).toEqual([25, -3, 0.25, 1]);
  expect(lab.held.value).toBe(undefined);
  expect(lab.clock.playing.value).toBe(true);
  hands.take();
  hands.release(false);
  expect(lab.setup.value.tilt_rate).toBe(0);
  vi.unstubAllGlobals();
});
