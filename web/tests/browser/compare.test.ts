// Two motions at once: in the picture, in numbers, in the plots, in the address, on paper and in a small frame.

import { expect, test } from "vitest";
import { violations } from "../given/axe";
import { browserForAll, visit } from "../given/visit";

browserForAll();

const PAIR =
  "friction=0.03&sideways=0.02&duration=1&with.body=can_2007&with.friction=0.8&with.sideways=0.02&with.duration=1";

const MIRROR = /#sideways=0\.02&.*with\.body=can_2007&with\.sideways=-0\.02&/;

test("a preset compares, the address holds it, set-ups are swapped, and it ends", async () => {
  const { page, complaints } = await visit();
  const compare = page.locator("#compare");
  expect(await compare.getByRole("table").isVisible()).toBe(false);
  const mirror = compare.getByRole("button", { name: "This start and its mirror" });
  await mirror.focus();
  await page.keyboard.press("Enter");
  const row = (name: string) =>
    compare
      .getByRole("row", { name: new RegExp(`^${name}`) })
      .getByRole("cell")
      .allTextContents();
  expect(await row("Sideways error")).toEqual(["0.02 rad/s", "−0.02 rad/s", ""]);
  const [mine, other, difference] = await row("Contact ran round");
  expect([mine, other, difference]).toEqual([mine, mine, "0.0°"]);
  expect(await compare.getByRole("status").textContent()).toContain("in both");
  await page.waitForURL(MIRROR);
  expect(await violations(page)).toEqual([]);

  await compare.getByRole("button", { name: "Swap A and B" }).click();
  await page.waitForURL(
    /#sideways=-0\.02&rolling=0\.0001&duration=1\.8&with\.body=can_2007&with\.sideways=0\.02&/,
  );
  expect(await row("Sideways error")).toEqual(["−0.02 rad/s", "0.02 rad/s", ""]);

  await page.getByRole("button", { name: "Undo" }).click();
  await page.waitForURL(MIRROR);
  await compare.getByRole("button", { name: "Stop comparing" }).click();
  await page.waitForFunction(() => location.hash === "#lab");
  expect(await compare.getByRole("table").isVisible()).toBe(false);
  // The focus is where a comparison can begin again.
  expect(await compare.locator("button:focus").count()).toBe(1);
  expect(complaints).toEqual([]);
});

test("a kept motion stays while the set-up changes", async () => {
  const { page } = await visit({ hash: "sideways=0.02&duration=1" });
  await page.getByRole("button", { name: "Keep this motion and change the set-up" }).click();
  const said = page.locator("#compare").getByRole("status");
  expect(await said.textContent()).toContain("Both set-ups are the same so far");
  await page.locator("#tilt-field").fill("10");
  await page.keyboard.press("Enter");
  await page.waitForURL(/tilt=10.*with\.body=can_2007/);
  const tilt = page.locator("#compare").getByRole("row", { name: /^Tilt/ });
  expect(await tilt.getByRole("cell").allTextContents()).toEqual(["10°", "20°", ""]);
  expect(await said.textContent()).toMatch(/in A and .* in B/);
});

test("the plots have both curves and say which is which", async () => {
  const { page } = await visit({ hash: PAIR });
  const tilt = page.locator("#plots figure", { hasText: "Tilt" }).first();
  await tilt.scrollIntoViewIfNeeded();
  const entry = tilt.locator(".entry", { hasText: "tilt, B" });
  await entry.waitFor();
  expect(await entry.locator("i.dashed").count()).toBe(1);
  await expect.poll(() => entry.textContent()).toMatch(/20\.00°$/);
  await page.locator("#compare").getByRole("button", { name: "Stop comparing" }).click();
  await entry.waitFor({ state: "hidden" });
});

test("on paper the numbers of a comparison stay, and its buttons do not", async () => {
  const paper = await visit({ hash: PAIR });
  await paper.page.emulateMedia({ media: "print" });
  expect(await paper.page.locator("#compare table").isVisible()).toBe(true);
  for (const name of ["Swap A and B", "Ice and rubber"])
    expect(await paper.page.getByRole("button", { name }).isVisible(), name).toBe(false);
});
