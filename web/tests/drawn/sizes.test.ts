// The page with its picture on a telephone, a laptop and a large screen; screenshots are in out/lab.

import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";
import { violations } from "../given/axe";
import { browserForAll, elsewhere, visit } from "../given/visit";

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

test("on paper the picture and all plots are there, and no buttons", async () => {
  const { page } = await visit({
    viewport: { width: 500, height: 700 },
    webgl: true,
    colorScheme: "dark",
  });
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  const picture = await page
    .locator(".table-stage")
    .evaluate((stage) => getComputedStyle(stage).backgroundImage);
  expect(picture).toMatch(/^url\("data:image\/png;base64,.{5000}/);
  // A blank plot has no opaque pixels.
  const blank = await page.$$eval("#plots canvas", (all) =>
    (all as HTMLCanvasElement[])
      .filter((canvas) => canvas.checkVisibility() && canvas.width > 0)
      .map((canvas) => {
        const pen = canvas.getContext("2d")!;
        return pen.getImageData(0, 0, canvas.width, canvas.height).data.every((byte) => byte === 0);
      }),
  );
  expect(blank.length).toBeGreaterThan(0);
  expect(blank).not.toContain(true);
  expect(await page.getByRole("button").filter({ visible: true }).allTextContents()).toEqual([]);
  // Ink is dark on paper.
  expect(await page.evaluate(() => getComputedStyle(document.body).color)).toBe("rgb(26, 33, 39)");
});
