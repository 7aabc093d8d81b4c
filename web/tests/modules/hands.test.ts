// Releases by hand, as values of the set-up.

import { expect, test, vi } from "vitest";
import { Lab } from "../../src/lab";
import { Hands } from "../../src/scene/hands";
import { type Orientation, leanOf, ontoTable } from "../../src/scene/telephone";
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

/** Which way the screen of a telephone faces, by the rotations of the W3C's specification: about z, then x, then y. */
function facing(alpha: number, { beta, gamma }: Orientation): [number, number, number] {
  const about = (axis: number, degrees: number, vector: number[]) => {
    const [c, s] = [Math.cos(degrees * DEGREE), Math.sin(degrees * DEGREE)];
    const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
    const turned = [...vector];
    turned[i] = c * vector[i]! - s * vector[j]!;
    turned[j] = s * vector[i]! + c * vector[j]!;
    return turned;
  };
  return about(2, alpha, about(0, beta!, about(1, gamma!, [0, 0, 1]))) as [number, number, number];
}

test("a telephone leans as far as its screen faces away from straight up, whatever its heading", () => {
  for (const orientation of [
    { beta: 0, gamma: 0 },
    { beta: 40, gamma: 0 },
    { beta: -30, gamma: 50 },
    { beta: 10, gamma: -20 },
  ]) {
    const { x, y } = leanOf(orientation, 0)!;
    for (const alpha of [0, 77]) {
      const [, , up] = facing(alpha, orientation);
      expect(Math.hypot(x, y)).toBeCloseTo(Math.acos(up), 12);
    }
  }
  expect(leanOf({ beta: null, gamma: null }, 0)).toBe(undefined);
});

test.each([
  ["its right edge lower, to the right", { beta: 0, gamma: 10 }, 0, { x: 10, y: 0 }],
  ["its upper edge lower, away from the reader", { beta: -10, gamma: 0 }, 0, { x: 0, y: 10 }],
  // Turned anticlockwise, its upper edge is at the left and its right edge is above.
  ["on its side, its left side lower, to the left", { beta: -10, gamma: 0 }, 90, { x: -10, y: 0 }],
  ["on its side, its far side lower, away", { beta: 0, gamma: 10 }, 90, { x: 0, y: 10 }],
])("a telephone with %s", (_, orientation, turned, lean) => {
  const { x, y } = leanOf(orientation, turned)!;
  expect(x / DEGREE).toBeCloseTo(lean.x, 10);
  expect(y / DEGREE).toBeCloseTo(lean.y, 10);
});

test("what leans away from the reader leans away from the camera", () => {
  const azimuth = -1.36;
  const { x, y } = ontoTable({ x: 0, y: 1 }, azimuth);
  expect([x, y]).toEqual([-Math.cos(azimuth), -Math.sin(azimuth)]);
  // To the right of the one who looks along this direction.
  const right = ontoTable({ x: 1, y: 0 }, azimuth);
  expect(right.x * y - right.y * x).toBeCloseTo(1, 12);
});
