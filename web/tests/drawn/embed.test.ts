// The page in a frame of another page.

import { expect, test } from "vitest";
import { violations } from "../given/axe";
import { addressOfPage, browserForAll, emptyPage, visit } from "../given/visit";

browserForAll();

test("in 640 by 360 the scene is in front, with playback and the button to let go", async () => {
  const { page, complaints } = await visit({
    hash: "embed&body=coin",
    viewport: { width: 640, height: 360 },
    webgl: true,
  });
  const box = (await page.locator("#scene").boundingBox())!;
  expect([box.x, box.y, box.width]).toEqual([0, 0, 640]);
  expect(box.height).toBeGreaterThan(230);
  for (const control of ["Let go", "Play", "Contact"]) {
    const one = (await page.getByRole("button", { name: control, exact: true }).boundingBox())!;
    expect(one.x + one.width, control).toBeLessThanOrEqual(640);
    expect(one.y + one.height, control).toBeLessThanOrEqual(360);
  }
  const size = () =>
    page.evaluate(() => {
      const { scrollHeight, scrollWidth } = document.documentElement;
      return [scrollWidth, scrollHeight];
    });
  expect(await size()).toEqual([640, 360]);
  expect(await violations(page)).toEqual([]);
  // The address stays that of the small page, and the link leads to the whole one.
  await page.getByRole("button", { name: "Contact", exact: true }).click();
  await page.waitForURL(/#embed&body=coin&view=contact$/);
  const whole = page.getByRole("link", { name: "Open the lab" });
  expect(await whole.getAttribute("href")).toMatch(/\/#body=coin&view=contact$/);
  expect(complaints).toEqual([]);
});

test("in a narrow frame of another page", async () => {
  const page = await emptyPage();
  await page.setContent(
    `<iframe width="320" height="240" src="${addressOfPage()}#embed&step=3"></iframe>`,
  );
  const frame = page.frameLocator("iframe");
  await frame.getByRole("button", { name: "Let go" }).waitFor();
  const wide = await page.frames()[1]!.evaluate(() => document.documentElement.scrollWidth);
  expect(wide).toBeLessThanOrEqual(320);
});
