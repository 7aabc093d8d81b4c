// The lab without a page.

import { vi } from "vitest";
import type { Core } from "../../src/core/core";
import { Lab } from "../../src/lab";
import type { Setup } from "../../src/setup/setup";

/** A lab with a set-up, optionally with reduced motion. */
export function labWith(core: Core, setup: Partial<Setup> = {}, still = false): Lab {
  vi.stubGlobal("matchMedia", () => ({ matches: still }));
  vi.stubGlobal("requestAnimationFrame", (draw: () => void) => setTimeout(draw));
  const lab = new Lab(core);
  lab.change(setup);
  return lab;
}
