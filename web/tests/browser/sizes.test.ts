// The page in space, at the sizes of a telephone, a laptop and a large screen; out/lab has the pictures.

import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";
import { violations } from "./axe";
import { browserForAll, elsewhere, leave, visit } from "./visit";

browserForAll();

const pictured = (name: string) =>
  fileURLToPath(new URL(`../../../out/lab/${name}.png`, import.meta.url));

test.each([
  [360, 740, "light"],
  [1366, 768, "dark"],
  [3840, 2160, "light"],
] as const)("%i by %i, %s", { timeout: 180_000 }, async (width, height, colorScheme) => {
  const visited = await visit({ viewport: { width, height }, colorScheme, webgl: true });
  const { page, complaints, requests } = visited;
  // Nobody scrolls sideways, and no words run out of their place.
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
    width,
  );
  await page.screenshot({ path: pictured(`${width}x${height}`), timeout: 120_000 });
  expect(await violations(page)).toEqual([]);
  expect(complaints).toEqual([]);
  expect(elsewhere(requests)).toEqual([]);
  await leave(visited);
});

test("keys tip the body on the table and let it go", { timeout: 120_000 }, async () => {
  const visited = await visit({ viewport: { width: 360, height: 740 }, webgl: true });
  const { page, complaints } = visited;
  const table = page.locator("#scene canvas");
  for (const key of ["+", "+", "-", "Enter"]) await table.press(key);
  await page.waitForFunction(() => location.hash === "#tilt=21");
  expect(await page.locator("#tilt-field").inputValue()).toBe("21");
  await table.press("+");
  await table.press("Escape");
  expect(await page.evaluate(() => location.hash)).toBe("#tilt=21");
  expect(complaints).toEqual([]);
  await leave(visited);
});
