// A scene of the essay alone, in a frame of a lesson's page or slide.

import { expect, test } from "vitest";
import { violations } from "../given/axe";
import { first } from "../given/soak";
import { addressOfPage, browserForAll, emptyPage, visit } from "../given/visit";

browserForAll();

const SLIDE = { viewport: { width: 640, height: 360 } };

test.each(first(1, ["question", "slap-or-roll", "friction"]))(
  "%s fits into 640 by 360, with the picture in front",
  async (scene) => {
    const { page, complaints } = await visit({ hash: `embed/${scene}`, webgl: true, ...SLIDE });
    const inFrame = async (place: string, least: number) => {
      const box = (await page.locator(`#${scene} ${place}`).first().boundingBox())!;
      expect(box.height, place).toBeGreaterThanOrEqual(least);
      expect([box.x >= 0, box.y >= 0, box.x + box.width <= 640, box.y + box.height <= 360]).toEqual(
        new Array(4).fill(true),
      );
      return box;
    };
    expect((await inFrame(".place", 180)).y).toBe(0);
    await inFrame(".go", 30);
    await inFrame("input[type=range]", 20);
    expect(await page.locator("#head").isVisible()).toBe(false);
    expect(await page.locator("#essay section:visible").count()).toBe(1);
    await page.locator(`#${scene} .go`).click();
    await page.waitForTimeout(1000);
    const size = await page.evaluate(() => {
      const { scrollHeight, scrollWidth } = document.documentElement;
      return [scrollWidth, scrollHeight];
    });
    expect(size).toEqual([640, 360]);
    expect(new URL(page.url()).hash).toBe(`#embed/${scene}`);
    // What it links to opens in another tab.
    const link = page.locator(`#${scene} .in-lab`);
    expect(await link.getAttribute("target")).toBe("_blank");
    expect(await violations(page)).toEqual([]);
    expect(complaints).toEqual([]);
  },
);

test("the code below a scene shows it in another page", async () => {
  const { page } = await visit({ hash: "hand" });
  const field = page.locator("#hand .frame-code");
  await field.getByText("Put this on a page or a slide").click();
  const shown = field.getByRole("textbox");
  await expect.poll(() => shown.inputValue()).toContain("<iframe");
  const code = await shown.inputValue();
  // The address of this page works only here, and the code says where a copy of the page must be.
  expect(await field.innerText()).toContain("Copy the folder of this page beside it");
  expect(code).toContain('src="lab/index.html#embed/hand"');
  await field.getByRole("button", { name: "Copy code" }).click();
  await field.getByText(/^(Code copied|Selected)/).waitFor();

  const lesson = await emptyPage();
  await lesson.setContent(code.replace("lab/index.html", addressOfPage()));
  const frame = lesson.frameLocator("iframe");
  await frame.getByRole("button", { name: "Let go" }).waitFor();
  expect(await frame.locator("#essay section:visible").count()).toBe(1);
  expect(await lesson.locator("iframe").getAttribute("title")).toBe("Why the hand does not matter");
});

test("an address of a scene that there is not shows the essay", async () => {
  const { page } = await visit({ hash: "embed/nonsense" });
  expect(await page.locator("#head").isVisible()).toBe(true);
  expect(await page.locator("#essay > section").count()).toBe(9);
});
