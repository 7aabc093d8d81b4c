// The page with its picture on a telephone, a laptop and a large screen; screenshots are in out/lab.

import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";
import { violations } from "./axe";
import { browserForAll, elsewhere, visit } from "./visit";

browserForAll();

const pictured = (name: string) =>
  fileURLToPath(new URL(`../../../out/lab/${name}.png`, import.meta.url));

test.each([
  [360, 740, "light"],
  [1366, 768, "dark"],
  [3840, 2160, "light"],
] as const)("%i by %i, %s", async (width, height, colorScheme) => {
  const visited = await visit({ viewport: { width, height }, colorScheme, webgl: true });
  const { page, complaints, requests } = visited;
  // Nothing is wider than the window.
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
    width,
  );
  // The labels say that the contact point runs round, and not the body.
  await page.waitForFunction(() => {
    const words = [...document.querySelectorAll<HTMLElement>(".table-words .word:not([hidden])")]
      .filter(({ style }) => style.visibility === "visible")
      .map(({ textContent }) => textContent);
    return (
      words.some((word) => /^contact ran round [\d.]+°$/.test(word)) &&
      words.some((word) => /^the can itself turned [\d.]+°$/.test(word))
    );
  });
  await page.screenshot({ path: pictured(`${width}x${height}`), timeout: 120_000 });
  expect(await violations(page)).toEqual([]);
  expect(complaints).toEqual([]);
  expect(elsewhere(requests)).toEqual([]);
});
