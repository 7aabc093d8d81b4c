// Hands on a telephone: what is in the first view, swipes, fingers that hold the body, and taking a change back.

import type { CDPSession, Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { browserForAll, visit } from "./visit";

browserForAll();

const PHONE = { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true };

/** A place on the body in the initial view. */
const BODY = { x: 150, y: 150 };

test("the story and the button to let go are in the first view, also after scrolling", async () => {
  const { page } = await visit(PHONE);
  const seen = async (place: ReturnType<Page["locator"]>) => {
    const box = (await place.boundingBox())!;
    return box.y >= 0 && box.y + box.height <= 740;
  };
  const letGo = page.getByRole("button", { name: "Let go" });
  expect(await seen(page.locator("#story"))).toBe(true);
  expect(await seen(letGo)).toBe(true);
  await page.locator("#share").scrollIntoViewIfNeeded();
  expect(await seen(letGo)).toBe(true);
  // The end of the page is not behind the button.
  await page.evaluate(() => scrollTo({ top: 1e6, behavior: "instant" }));
  const foot = (await page.locator("#foot p").last().boundingBox())!;
  expect(foot.y + foot.height).toBeLessThan((await letGo.boundingBox())!.y);
});

describe("a finger", () => {
  async function withFinger(what: (page: Page, finger: CDPSession) => Promise<void>) {
    const { page, complaints } = await visit({ ...PHONE, webgl: true });
    await what(page, await page.context().newCDPSession(page));
    expect(complaints).toEqual([]);
  }
  const touch = (finger: CDPSession, type: "touchStart" | "touchMove" | "touchEnd", y = 0) =>
    finger.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: type === "touchEnd" ? [] : [{ x: BODY.x, y }],
    });

  test("that swipes up over the body scrolls the page and tips nothing", async () => {
    await withFinger(async (page, finger) => {
      await page.waitForTimeout(1500); // until the first pictures are drawn
      const start = touch(finger, "touchStart", BODY.y + 50);
      const moves = [...Array(6).keys()].map((k) =>
        touch(finger, "touchMove", BODY.y + 38 - 18 * k),
      );
      await Promise.all([start, ...moves]);
      await touch(finger, "touchEnd");
      await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(40);
      await page.getByText("Hold the body for a moment, then tip it.").waitFor();
      await page.waitForTimeout(500); // longer than the page waits before it writes its address
      expect(new URL(page.url()).hash).toBe("#lab");
    });
  });

  test("that rests on the body takes it, and what it did can be undone", async () => {
    await withFinger(async (page, finger) => {
      const undo = page.getByRole("button", { name: "Undo" });
      expect(await undo.getAttribute("aria-disabled")).toBe("true");
      await touch(finger, "touchStart", BODY.y);
      await page.locator("canvas.holding").waitFor();
      await touch(finger, "touchMove", BODY.y + 12);
      await touch(finger, "touchMove", BODY.y + 24);
      await page.waitForTimeout(300);
      await touch(finger, "touchEnd");
      await page.waitForURL(/tilt=/);
      expect(await page.evaluate(() => scrollY)).toBe(0);
      await undo.click();
      await page.waitForFunction(() => location.hash === "#lab");
      expect(await page.locator("#tilt-field").inputValue()).toBe("20");
      expect(await undo.getAttribute("aria-disabled")).toBe("true");
    });
  });
});

test("a slider's moves are undone together, and earlier changes one by one", async () => {
  const { page } = await visit();
  const [tilt, body] = [page.locator("#tilt-slider"), page.locator("#body-field")];
  await body.selectOption("coin");
  await page.waitForURL(/#body=coin&sideways=0.02&rolling=0.0001&duration=1.8$/);
  await page.waitForTimeout(800); // longer than the pause between changes that belong together
  await tilt.focus();
  await page.keyboard.press("ArrowRight", { delay: 20 });
  await page.keyboard.press("ArrowRight", { delay: 20 });
  await page.waitForURL(/#body=coin&tilt=21&sideways/);
  const undo = page.getByRole("button", { name: "Undo" });
  await undo.click();
  await page.waitForURL(/#body=coin&sideways=0.02&rolling=0.0001&duration=1.8$/);
  await undo.click();
  await page.waitForFunction(() => location.hash === "#lab");
  expect(await undo.evaluate((it) => it === document.activeElement)).toBe(true);
});
