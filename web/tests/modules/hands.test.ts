// What a hand lets go, as values of the set-up.

import { expect, test } from "vitest";
import { released } from "../../src/scene/hands";
import { FIELDS } from "../../src/setup/fields";
import { INITIAL } from "../../src/setup/setup";

const DEGREE = Math.PI / 180;
const REST = { x: 0, y: 0 };

test("a hand that rests lets go exactly at rest, but for what no hand can help", () => {
  const setup = released({ tilt: 0.4, yaw: 0.3 }, REST, { ...INITIAL, sideways: 0.003 });
  expect(setup).toEqual({ tilt: 22.9, yaw: 17.2, tilt_rate: 0, twist: 0, sideways: 0.003 });
});

test("a flick before does not make the next hand unsteady", () => {
  const setup = released({ tilt: 0.4, yaw: 0 }, REST, { ...INITIAL, sideways: 1.5 });
  expect(setup.sideways).toBe(FIELDS.sideways.initial);
});

test("a hand that leads the lean back to upright flicks with a falling tilt", () => {
  // With yaw 0 the body leans toward −x.
  const setup = released({ tilt: 20 * DEGREE, yaw: 0 }, { x: 2, y: 0 }, INITIAL);
  expect(setup.tilt_rate).toBe(-2);
  expect(setup.sideways).toBe(INITIAL.sideways);
});

test("led round anticlockwise, the yaw rate is that of the hand", () => {
  const tilt = 20 * DEGREE;
  const setup = released({ tilt, yaw: 0 }, { x: 0, y: -0.5 }, INITIAL);
  // yaw rate = sideways · cot(tilt): the hand goes round at its speed over the tilt.
  const yawRate = (setup.sideways as number) / Math.tan(tilt);
  expect(yawRate).toBeCloseTo(0.5 / tilt, 2);
});

test("a direction is from −180 up to 180 degrees, whichever way round the hand went", () => {
  expect(released({ tilt: 0.4, yaw: 1.5 * Math.PI }, REST, INITIAL).yaw).toBe(-90);
  expect(released({ tilt: 0.4, yaw: -3 * Math.PI }, REST, INITIAL).yaw).toBe(-180);
});

test("no hand flicks faster than fields allow", () => {
  const { tilt_rate } = released({ tilt: 0.4, yaw: 0 }, { x: -1e4, y: 0 }, INITIAL);
  expect(tilt_rate).toBe(25);
});
