// The part of the page that is loaded when a visitor first shakes the floor.

import { ShakenCore } from "./shaken_core";
import { shakerWith } from "./shaker";
import type { Shaker } from "./shaking";

export { mountFloorControls } from "./controls";

let shaker: Promise<Shaker> | undefined;

/** Loads the core with tables that move; a second call gives the same one. */
export function loadShaker(): Promise<Shaker> {
  return (shaker ??= loadCore().then(shakerWith));
}

/** The page that rimroll.lab makes carries this core in place of the other. */
const loadCore = async (): Promise<ShakenCore> =>
  ShakenCore.load(
    import.meta.env.MODE === "alone"
      ? (globalThis as unknown as { rimrollCore: ArrayBuffer }).rimrollCore
      : await fetch(new URL("../core/rimroll-ground.wasm", import.meta.url)),
  );
