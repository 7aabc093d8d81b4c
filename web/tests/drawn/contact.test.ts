// The contact point seen from nearby and from below the table.

import type { Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { violations } from "../given/axe";
import { browserForAll, visit } from "../given/visit";

browserForAll();

const PHONE = { viewport: { width: 360, height: 740 }, webgl: true };

const unrolled = (page: Page) => page.locator(".table-unrolled");
const gap = (page: Page) => page.locator(".word.gap");

/** Goes to a moment just after the collision, when the contact point races. */
async function justAfterCollision(page: Page): Promise<void> {
  await page.getByRole("button", { name: "To the next collision" }).click();
  for (let frame = 0; frame < 5; frame++)
    await page.getByRole("button", { name: "Next frame" }).click();
}

describe("from nearby", () => {
  test("the gap is magnified by the factor that is written beside it", async () => {
    const { page, complaints } = await visit({ ...PHONE, hash: "body=can_2007" });
    const button = page.getByRole("button", { name: "Contact", exact: true });
    expect(await unrolled(page).count()).toBe(0);
    await button.click();
    expect(await button.getAttribute("aria-pressed")).toBe("true");
    await unrolled(page).waitFor();
    await justAfterCollision(page);
    await gap(page)
      .filter({ hasText: /^gap 3\.\d\sµm, drawn 5000 × as high$/ })
      .waitFor();
    await page.waitForURL(/view=contact$/);
    expect(await violations(page)).toEqual([]);
    await button.click();
    await page.waitForFunction(() => location.hash === "#body=can_2007");
    await unrolled(page).waitFor({ state: "hidden" });
    expect(complaints).toEqual([]);
  });

  test("the rim and the table are unrolled: equally long where the body rolls", async () => {
    const { page } = await visit({ ...PHONE, hash: "view=contact" });
    await unrolled(page).waitFor();
    await justAfterCollision(page);
    const [table, rim] = await unrolled(page).locator("b").allInnerTexts();
    expect(table).toMatch(/^\d+(\.\d)?\scm$/);
    expect(rim).toBe(table);
    await page
      .getByRole("img", { name: /run (\S+\scm) along the rim and \1 along the table: it rolls/ })
      .waitFor();
  });

  test("and it is said how far it has slipped where it slides", async () => {
    const { page } = await visit({ ...PHONE, hash: "law=frictionless&view=contact" });
    await unrolled(page).waitFor();
    await justAfterCollision(page);
    await unrolled(page)
      .getByText(/its rim has slipped \d+(\.\d)?\s[cm]m/)
      .waitFor();
  });
});

test("at the end of a turn its angle is above the strips", async () => {
  const { page } = await visit({ ...PHONE, hash: "slap-or-roll", reducedMotion: "reduce" });
  await unrolled(page).waitFor();
  await page.locator("#slap-or-roll-control").fill("1000");
  const turned = page.locator(".word.turned").filter({ hasText: "ran round 203.9°" });
  await turned.waitFor();
  await expect
    .poll(async () => {
      const [label, strips] = [await turned.boundingBox(), await unrolled(page).boundingBox()];
      return label!.y + label!.height - strips!.y;
    })
    .toBeLessThan(0);
});

test("the name of the pressed button can be read under the pointer", async () => {
  const { page } = await visit({ viewport: { width: 1366, height: 768 }, webgl: true });
  const button = page.getByRole("button", { name: "Contact", exact: true });
  await button.click();
  const [ink, ground] = await button.evaluate((it) => {
    const { color, backgroundColor } = getComputedStyle(it);
    return [it.matches(":hover") && color, backgroundColor];
  });
  expect(ink).toBeTruthy();
  expect(ink).not.toBe(ground);
});

test("the table can be seen from below, and the keys lead there too", async () => {
  const { page, complaints } = await visit({ ...PHONE, reducedMotion: "reduce" });
  await page.getByRole("button", { name: "From below" }).click();
  await unrolled(page).waitFor();
  // From below, what is farther away is lower in the picture: 0° is to the left, and the theory to the right.
  const place = (word: string) =>
    page.locator(`.word.${word}`).evaluate((it) => it.getBoundingClientRect().top);
  await justAfterCollision(page);
  const below = await place("turned");
  const canvas = page.locator("#scene canvas");
  for (let press = 0; press < 20; press++) await canvas.press("ArrowUp");
  await expect.poll(() => place("turned")).toBeGreaterThan(below + 20);
  expect(complaints).toEqual([]);
});

test("a link from below is refused in words if it is misspelt", async () => {
  const { page } = await visit({ hash: "view=beneath" });
  await page
    .getByText("View: there is no “beneath”; choose whole, above, contact or below.")
    .waitFor();
});
