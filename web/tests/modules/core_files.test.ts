// A file that is no core of the page is refused in words.

import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { Core } from "../../src/core/core";

const CORE = readFileSync(new URL("../../src/core/rimroll.wasm", import.meta.url));
/** The header of a WebAssembly module, and nothing else. */
const EMPTY = Uint8Array.from([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);

test.each([
  [
    "cut off",
    CORE.subarray(0, CORE.length / 2),
    /^the file of the mechanics is damaged or is none$/,
  ],
  ["a page", new TextEncoder().encode("<!doctype html>"), /is damaged or is none$/],
  ["another module", EMPTY, /^the file of the mechanics does not belong to this page$/],
])("%s", async (_name, file, message) => {
  await expect(Core.load(Uint8Array.from(file))).rejects.toThrow(message);
});
