// Random set-ups.

import { FIELD_NAMES, type FieldName, FIELDS } from "../../src/setup/fields";
import { INITIAL, type Setup } from "../../src/setup/setup";
import type { Chance } from "./chance";

/** A random value that a field accepts, including its bounds. */
function anyValue(name: FieldName, chance: Chance): number | string {
  const field: (typeof FIELDS)[FieldName] = FIELDS[name];
  if (field.kind === "choice") return chance.one(Object.keys(field.choices));
  if (name === "falls") return chance.one(["", "213", "146.5_360_7"]);
  if (field.kind === "record") return chance.one(["", "AAAA_-9z", "w-".repeat(300)]);
  const between = chance.between(field.min, field.max);
  const inside = "whole" in field ? Math.round(between) : between;
  return chance.one([inside, field.initial, "open" in field ? inside : field.min]);
}

/** A set-up that the fields accept, whether it can be computed or not. */
export const anySetup = (chance: Chance): Setup =>
  Object.fromEntries(FIELD_NAMES.map((name) => [name, anyValue(name, chance)])) as unknown as Setup;

/** Any body, released or flicked on any table, followed for 0.5 s. */
export function likelySetup(chance: Chance): Setup {
  return {
    ...INITIAL,
    body: chance.one(Object.keys(FIELDS.body.choices)) as Setup["body"],
    law: chance.one(Object.keys(FIELDS.law.choices)) as Setup["law"],
    fill: chance.between(0, 100),
    radius: chance.between(1, 10),
    length: chance.one([0, chance.between(1, 30)]),
    mass: chance.between(5, 500),
    wall: chance.between(0, 100),
    base: chance.between(0, 60),
    height: chance.one([0, chance.between(1, 15)]),
    transverse: chance.between(10, 60),
    axial: chance.between(1, 20),
    tilt: chance.between(3, 40),
    tilt_rate: chance.one([0, chance.between(-2, 0.5)]),
    sideways: chance.one([0, 1]) * chance.between(-0.1, 0.1),
    twist: chance.one([0, chance.between(-0.1, 0.1)]),
    yaw: chance.one([0, chance.between(-180, 180)]),
    friction: chance.between(0.02, 0.9),
    rolling: chance.one([0, chance.between(0, 0.01)]),
    restitution: chance.one([0, chance.between(0, 0.9)]),
    gravity: chance.one([INITIAL.gravity, 1.62]),
    duration: 0.5,
  };
}
