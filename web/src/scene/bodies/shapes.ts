// Drawn sizes of the bodies: nominal sizes of everyday objects.

import type { Setup } from "../../setup/setup";
import { RING_RADIUS } from "../../setup/simulation_input";

/** m */
export interface Size {
  /** radius of the rim on which the body stands */
  rim: number;
  /** radius of the widest part */
  widest: number;
  length: number;
}

export function sizeOf(setup: Readonly<Setup>): Size {
  switch (setup.body) {
    case "can_2007":
      return { rim: 0.051, widest: 0.051, length: 0.138 };
    case "soda_can":
      return { rim: 0.024, widest: 0.033, length: 0.115 };
    case "beer_bottle":
      return { rim: 0.026, widest: 0.0305, length: 0.23 };
    case "coin":
      return { rim: 0.5 * 23.25e-3, widest: 0.5 * 23.25e-3, length: 2.33e-3 };
    case "ring":
      return { rim: RING_RADIUS, widest: RING_RADIUS, length: 0.12 * RING_RADIUS };
    case "battery":
      return { rim: 7.25e-3, widest: 7.25e-3, length: 50.5e-3 };
    case "euler_disk":
      return { rim: 0.0375, widest: 0.0375, length: 12.7e-3 };
    case "own": {
      const [radius, length] = [setup.radius / 100, setup.length / 100];
      return { rim: radius, widest: radius, length: Math.max(length, 0.03 * radius) };
    }
    case "inertia": {
      // As long as if the centre of mass were in the middle.
      const [radius, length] = [setup.radius / 100, (2 * setup.height) / 100];
      return { rim: radius, widest: radius, length: Math.max(length, 0.03 * radius) };
    }
  }
}

/** Radius of the circle of degrees round a body, m, which is the unit of length of the scene. */
export const reachOf = ({ widest, length }: Size) =>
  Math.max(1.6 * widest, 0.95 * widest + 0.4 * length);
