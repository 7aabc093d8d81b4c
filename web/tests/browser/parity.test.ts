// The CSV file and the Python code of the page give the same motion to the last bit.

import { readFile } from "node:fs/promises";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { INITIAL } from "../../src/setup/setup";
import { toHash } from "../../src/setup/url";
import { Chance } from "../given/chance";
import { columnsOf, difference, run } from "../given/python";
import { likelySetup } from "../given/setups";
import { browserForAll, visit } from "../given/visit";

browserForAll();

async function taken(page: Page): Promise<{ code: string; csv: string }> {
  // Only a page with the focus can use the clipboard.
  await page.bringToFront();
  await page.getByRole("button", { name: "Copy as Python" }).click();
  await page.getByText("Python code copied.").waitFor();
  const code = await page.evaluate(() => navigator.clipboard.readText());
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Download CSV" }).click(),
  ]);
  return { code, csv: await readFile(await file.path(), "utf8") };
}

test("Python computes from the copied code what was downloaded", async () => {
  const chance = new Chance(42);
  const setups = [INITIAL, { ...INITIAL, tilt_rate: -3 }, { ...INITIAL, sideways: 0 }];
  while (setups.length < 20) setups.push(likelySetup(chance));

  const visited = await visit();
  const ours: { code: string; csv: string }[] = [];
  for (const setup of setups) {
    const hash = toHash(setup);
    await visited.page.evaluate((hash) => (location.hash = hash), hash || "lab");
    // The page has read the set-up when the shared command holds it.
    await visited.page.waitForFunction(
      (hash) =>
        (document.getElementById("share-link") as HTMLInputElement).value ===
        `rimroll lab${hash && ` --setup "${hash}"`}`,
      hash,
    );
    ours.push(await taken(visited.page));
  }

  const theirs = await run(ours.map(({ code }) => code));
  for (const [k, { code, csv }] of ours.entries())
    expect(difference(columnsOf(csv), theirs[k]?.columns ?? new Map()), code).toBe(undefined);
});
