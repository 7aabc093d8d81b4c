import { readFile } from "node:fs/promises";
import { Core } from "../../src/core/core";

/** The core as the page loads it, here from its file. */
export const loadCore = async (): Promise<Core> =>
  Core.load(await readFile(new URL("../../src/core/rimroll.wasm", import.meta.url)));
