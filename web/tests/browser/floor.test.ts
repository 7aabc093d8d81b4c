// A visitor shakes the floor: with a pulse, with a hand on the pad, and with keys.

import type { Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { violations } from "../given/axe";
import { browserForAll, visit } from "../given/visit";

browserForAll();

const said = (page: Page) => page.locator("#verdict .words");

async function open(page: Page): Promise<void> {
  await page.getByText("The floor: at rest").click();
  await page.getByRole("group", { name: "Floor" }).waitFor();
}

test("a pulse overturns a can that stands", async () => {
  const { page, complaints } = await visit({ hash: "body=can_2007" });
  expect(await page.locator("details.floor").getAttribute("open")).toBe(null);
  await page.getByLabel("Body", { exact: true }).selectOption("soda_can");
  await open(page);
  await page.getByLabel("A pulse").check();
  await page.getByLabel("Standing flat").check();
  await page.locator("#shake-field").fill("6 m/s²");
  await page.locator("#shake-field").press("Enter");
  await said(page)
    .getByText(/begins to rock at .* overturns|begins to rock/)
    .waitFor();
  expect(await said(page).innerText()).toMatch(/\(uplift\)[^]*The can overturns at 519\sms\./);
  expect(await page.locator("#tilt-field").isDisabled()).toBe(true);
  await page.getByRole("button", { name: "Shake", exact: true }).click();
  await page.waitForURL(/floor=pulse&start=standing&shake=6$/);
  // The floor's plot is the first.
  await page.getByRole("link", { name: "Plots" }).click();
  const first = page.locator("#plots figure:visible").first();
  expect(await first.getByRole("img").getAttribute("aria-label")).toMatch(
    /^Floor, acceleration over time/,
  );
  expect(await page.locator("#share-code").textContent()).toContain("rr.ground.sine(");
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await page.getByText("The floor: at rest").waitFor();
  expect(complaints).toEqual([]);
});

describe("by hand", () => {
  const hash = "floor=hand&start=standing&body=soda_can&law=no_slip";

  test("a path on the pad becomes a record in the address", async () => {
    const { page, complaints } = await visit({ hash });
    await said(page).getByText("The floor does not move.").waitFor();
    const pad = page.getByRole("application", { name: "Move the table" });
    await pad.scrollIntoViewIfNeeded();
    const box = (await pad.boundingBox())!;
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (const far of [60, -60, 60]) await page.mouse.move(x + far, y, { steps: 3 });
    await page.mouse.up();
    await page.waitForURL(/record=[\w-]{80}/);
    expect(await said(page).innerText()).toMatch(/^The floor moves by up to/);
    expect(complaints).toEqual([]);
  });

  test("the arrow keys move the table", async () => {
    const { page } = await visit({ hash });
    const pad = page.getByRole("application", { name: "Move the table" });
    await pad.focus();
    for (const key of ["ArrowRight", "ArrowLeft"]) await pad.press(key);
    await page.waitForURL(/record=[\w-]{80}/);
    await said(page).getByText("The floor moves by up to").waitFor();
  });

  test("a push is away from the visitor", async () => {
    const { page } = await visit();
    await open(page);
    await page.getByRole("button", { name: "Push" }).click();
    await page.waitForURL(/floor=pulse&pulse=half_sine&period=0.2&direction=90/);
    await said(page).getByText("The floor moves by up to").waitFor();
  });
});

test.each([
  [360, 740, "light"],
  [820, 1180, "dark"],
  [1366, 768, "light"],
] as const)(
  "with %i by %i pixels, %s, the controls are accessible",
  async (width, height, colorScheme) => {
    const { page, complaints } = await visit({
      viewport: { width, height },
      colorScheme,
      hash: "floor=hand&start=standing",
    });
    await page.getByRole("application", { name: "Move the table" }).waitFor();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
      width,
    );
    expect(await violations(page)).toEqual([]);
    await page.getByLabel("A pulse").check();
    await page.locator("#shake-slider").waitFor();
    expect(await violations(page)).toEqual([]);
    expect(complaints).toEqual([]);
  },
);
