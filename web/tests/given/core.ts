import { readFile } from "node:fs/promises";
import { Core } from "../../src/core/core";
import type { Motion } from "../../src/core/motion";
import { ShakenCore, shakerWith } from "../../src/floor/floor";
import { type SimulationInput, simulationInput } from "../../src/setup/simulation_input";
import { INITIAL, type Setup } from "../../src/setup/setup";

/** Loads the core as the page does, but from its file. */
export const loadCore = async (): Promise<Core> =>
  Core.load(await readFile(new URL("../../src/core/rimroll.wasm", import.meta.url)));

/** The whole motion of the initial set-up with some changes. */
export function motionOf(core: Core, changes: Partial<Setup> = {}): Motion {
  const { body, start, contactLaw, options } = simulationInput(core, { ...INITIAL, ...changes });
  return core.simulate(body, start, contactLaw, options);
}

/** Loads the core with tables that move. */
export const loadShakenCore = async (): Promise<ShakenCore> =>
  ShakenCore.load(await readFile(new URL("../../src/core/rimroll-ground.wasm", import.meta.url)));

/** What is simulated for a set-up whose floor moves. */
export function shakenInput(core: ShakenCore, setup: Readonly<Setup>): SimulationInput {
  return shakerWith(core).inputOf(setup, simulationInput(core, setup));
}
