// The drawn body compared with the contact point of the mechanics.

import { Matrix4, Vector3 } from "three";
import { beforeAll, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import { sizeOf } from "../../src/scene/bodies/shapes";
import { footingOf, heldPose, poseOf, setPose } from "../../src/scene/pose";
import { FIELDS } from "../../src/setup/fields";
import { bodyOf, simulationInput } from "../../src/setup/simulation_input";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { loadCore } from "../given/core";

let core: Core;
beforeAll(async () => {
  core = await loadCore();
});

function moved(changes: Partial<Setup>) {
  const { body, start, contactLaw, options } = simulationInput(core, { ...INITIAL, ...changes });
  const motion = core.simulate(body, start, contactLaw, options);
  return { body, motion, footing: footingOf(motion, body) };
}

const SETUPS: [string, Partial<Setup>][] = [
  ["a can that rolls", {}],
  ["a can on ice, leanFields elsewhere", { law: "frictionless", yaw: 70 }],
  ["a can that slips", { friction: 0.1, yaw: -140 }],
  ["a coin set spinning", { body: "coin", tilt: 80, twist: 6 }],
];

test.each(SETUPS)("%s touches the table where the mechanics says", (_, changes) => {
  const { body, motion, footing } = moved(changes);
  for (const t of [0, 0.1, 0.3, 1, 2]) {
    const moment = motion.at([t]).moment(0);
    const place = setPose(new Matrix4(), poseOf(moment, body.height, footing.shift));
    const { spin } = moment;
    // The lowest point of the rim is half a revolution behind the spin.
    const low = new Vector3(-Math.cos(spin), Math.sin(spin), 0).multiplyScalar(body.radius);
    const { x, y, z } = low.applyMatrix4(place);
    expect(x).toBeCloseTo(moment.contact_x + footing.shift.x, 12);
    expect(y).toBeCloseTo(moment.contact_y + footing.shift.y, 12);
    expect(z).toBeCloseTo(moment.gap, 12);
  }
});

test.each(SETUPS)("%s starts where the hand held it", (_, changes) => {
  const { body, motion, footing } = moved(changes);
  const start = motion.at([0]).moment(0);
  const held = heldPose(body, start.tilt, start.yaw, footing.slide);
  const begun = poseOf(start, body.height, footing.shift);
  for (const key of ["tilt", "yaw", "x", "y", "z"] as const)
    expect(begun[key]).toBeCloseTo(held[key], 12);
});

test("a rolling body is tipped about its rim at rest, a body on ice about its centre of mass", () => {
  expect(moved({}).footing.slide).toBeLessThan(0.01);
  expect(moved({ law: "frictionless" }).footing.slide).toBeGreaterThan(0.99);
});

test.each(Object.keys(FIELDS.body.choices) as Setup["body"][])(
  "the rim of %s is drawn with the radius that the mechanics computes with",
  (body) => {
    const setup = { ...INITIAL, body };
    expect(sizeOf(setup).rim).toBeCloseTo(bodyOf(core, setup).radius, 12);
  },
);
