// Converts the set-up from the visitor's units to the input of the core.

import type { Body, ContactLaw, Core, Input, Solid, State } from "../core/core";
import type { Shaking } from "../floor/shaking";
import type { Setup } from "./setup";
import { Refused } from "../core/exchange";
import { say, words } from "../words/words";

export const RING_RADIUS = 0.05;

const RADIANS = Math.PI / 180;

/** Everything that determines a motion, in SI units and radians. */
export interface SimulationInput extends Input {
  /** How the floor moves; without it the floor is at rest. */
  shaking?: Shaking;
}

/** Throws `Refused` for an impossible body. */
export function simulationInput(core: Core, setup: Readonly<Setup>): SimulationInput {
  return {
    body: bodyOf(core, setup),
    start: startOf(setup),
    contactLaw: contactLawOf(setup),
    options: { duration: setup.duration, gravity: setup.gravity, rtol: 1e-10, maxSteps: 50_000 },
  };
}

export function bodyOf(core: Core, setup: Readonly<Setup>): Body {
  switch (setup.body) {
    case "own":
      return core.composed(setup.radius / 100, solidsOf(setup));
    case "inertia":
      return byInertia(setup);
    case "ring":
      return core.preset("ring", RING_RADIUS);
    default:
      return core.preset(setup.body, setup.fill / 100);
  }
}

/** A body by its mass, its centre of mass and its moments of inertia. */
function byInertia(setup: Readonly<Setup>): Body {
  const mass = setup.mass / 1000;
  return {
    mass,
    radius: setup.radius / 100,
    height: setup.height / 100,
    transverseInertia: (mass * setup.transverse) / 1e4,
    axialInertia: (mass * setup.axial) / 1e4,
  };
}

/** The visitor's own body: a base plate, a side wall and a solid filling up to the top. */
export function solidsOf(setup: Readonly<Setup>): Solid[] {
  const [radius, length, mass] = [setup.radius / 100, setup.length / 100, setup.mass / 1000];
  const inBase = setup.base / 100;
  const inWall = (setup.wall / 100) * (1 - inBase);
  const parts: [Solid["shape"], number][] = [
    ["disk", inBase],
    ["wall", inWall],
    ["cylinder", 1 - inBase - inWall],
  ];
  return parts
    .filter(([, part]) => part > 0)
    .map(([shape, part]) => ({ shape, mass: part * mass, radius, length, base: 0 }));
}

/** The start of a release by hand: besides tilting, the body turns about the line along which it leans
 * (`sideways`) and about the vertical (`twist`); see rimroll.Release. */
export function startOf(setup: Readonly<Setup>): State {
  const tilt = setup.tilt * RADIANS;
  const [sin, cos] = [Math.sin(tilt), Math.cos(tilt)];
  return {
    tilt,
    tiltRate: setup.tilt_rate,
    yaw: setup.yaw * RADIANS,
    yawRate: setup.twist + (setup.sideways * cos) / sin,
    spin: 0,
    spinRate: -setup.sideways / sin,
  };
}

export function contactLawOf(setup: Readonly<Setup>): ContactLaw {
  const resistance = setup.rolling > 0 ? { rollingDry: setup.rolling } : {};
  if (setup.law !== "coulomb") return { law: setup.law, ...resistance };
  const { friction, restitution } = setup;
  return { law: "coulomb", friction, restitution, ...resistance };
}

// The reason why the core gave no answer, in words.

/** The reason behind an error of the core; any other error is thrown again. */
export function reasonOrRethrow(error: unknown): string {
  if (error instanceof Refused) return error.message;
  // The computation broke off, for example for lack of memory.
  if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError)
    return say(words.verdict.computationFailed, { why: error.message });
  throw error;
}
