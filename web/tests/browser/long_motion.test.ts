// A long motion is computed in a worker, and is the same to the last bit as one that is computed at once.

import { readFile } from "node:fs/promises";
import type { Page } from "playwright-core";
import { beforeAll, expect, test } from "vitest";
import type { Core } from "../../src/core/core";
import type { ShakenCore } from "../../src/floor/floor";
import { toCsv } from "../../src/setup/export";
import { INITIAL, type Setup } from "../../src/setup/setup";
import { toHash } from "../../src/setup/url";
import { loadCore, loadShakenCore, motionOf, shakenInput } from "../given/core";
import { browserForAll, visit } from "../given/visit";

browserForAll();

const LONG: Setup = { ...INITIAL, body: "coin" };
const SHAKEN: Setup = { ...LONG, floor: "pulse" };

let core: Core;
let shakenCore: ShakenCore;
beforeAll(async () => {
  [core, shakenCore] = [await loadCore(), await loadShakenCore()];
});

/** The motion as a file, from the moment at which it is complete. */
async function saved(page: Page): Promise<string> {
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Download CSV" }).click(),
  ]);
  return readFile(await file.path(), "utf8");
}

/** The addresses of the workers that a page starts. */
function workersOf(page: Page): string[] {
  const addresses: string[] = [];
  page.on("worker", (worker) => addresses.push(worker.url()));
  return addresses;
}

test("on a table at rest", async () => {
  const { page, complaints } = await visit();
  const workers = workersOf(page);
  await page.evaluate((hash) => (location.hash = hash), toHash(LONG));
  await page.getByText("is still being computed").waitFor();
  await page.getByText("is still being computed").waitFor({ state: "detached" });
  expect(workers.length).toBe(1);
  expect(await saved(page)).toBe(toCsv(motionOf(core, LONG)));
  expect(workers.length).toBe(1);
  expect(complaints).toEqual([]);
});

test("on a floor that moves", async () => {
  const { page, complaints } = await visit();
  const workers = workersOf(page);
  await page.evaluate((hash) => (location.hash = hash), toHash(SHAKEN));
  await page.getByText("The floor moves by up to").first().waitFor();
  const input = shakenInput(shakenCore, SHAKEN);
  const motion = input.shaking!.simulation(input).now();
  expect(motion.samples(1).length).toBeGreaterThan(3000);
  expect(await saved(page)).toBe(toCsv(motion, input.shaking));
  expect(workers.length).toBe(1);
  expect(complaints).toEqual([]);
});

test("by the page where no worker can be loaded", async () => {
  const { page, requests } = await visit();
  await page.route(/worker-/, (route) => route.abort());
  await page.evaluate((hash) => (location.hash = hash), toHash(LONG));
  await page.getByText("is still being computed").waitFor();
  expect(await saved(page)).toBe(toCsv(motionOf(core, LONG)));
  expect(requests.filter((address) => /worker-/.test(address)).length).toBe(1);
});
