// Hands on a telephone: what is in the first view, swipes, fingers that hold the body, and taking a change back.

import type { CDPSession, Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { browserForAll, visit } from "../given/visit";

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

describe("the telephone as the hand", () => {
  const turn = (page: Page, beta: number | null, gamma: number | null) =>
    page.evaluate(
      (angles) => {
        dispatchEvent(new DeviceOrientationEvent("deviceorientation", angles));
      },
      { alpha: 0, beta, gamma },
    );
  const hold = (page: Page) =>
    page.getByRole("button", { name: "Hold this, tip the phone, let go" });
  const ask = (page: Page) => page.getByRole("button", { name: "Use the tilt of this phone" });
  /** The set-up of the scene, in the link to the lab. */
  const setup = async (page: Page) => {
    const link = page.locator("#your-turn .in-lab");
    return new URLSearchParams((await link.getAttribute("href"))!.slice(1));
  };
  /** Waits until the scene is alive. */
  const shown = (page: Page) =>
    page.locator("#your-turn .table-stage").waitFor({ state: "attached" });

  test("the button appears where there is a sensor", async () => {
    const { page } = await visit({ ...PHONE, hash: "your-turn" });
    await shown(page);
    await turn(page, null, null);
    expect(await hold(page).count()).toBe(0);
    await turn(page, 40, 0);
    await hold(page).waitFor();
    expect(await ask(page).count()).toBe(0);
  });

  test("the can tips as the telephone does, and is let go with the button", async () => {
    const { page, complaints } = await visit({ ...PHONE, hash: "your-turn" });
    await shown(page);
    await turn(page, 40, 0);
    await hold(page).scrollIntoViewIfNeeded();
    // The can leans to the left at the release.
    await page.getByRole("button", { name: "Let go" }).last().click();
    await page.waitForTimeout(300);
    const { x, y, width, height } = (await hold(page).boundingBox())!;
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await turn(page, 40, 0);
    const before = await setup(page);
    expect(before.get("tilt")).toBe(null); // 20°, the initial value
    // The upper edge goes down from 40° to 0°: the telephone tips away from the reader.
    for (let beta = 36; beta >= 0; beta -= 4) await turn(page, beta, 0);
    await page.waitForTimeout(300); // a hand at rest
    await page.mouse.up();
    await expect.poll(async () => (await setup(page)).get("yaw")).not.toBe(null);
    const [tilt, yaw] = ["tilt", "yaw"].map(async (name) => Number((await setup(page)).get(name)));
    expect(await tilt).toBeGreaterThan(15);
    // It leans opposite to its yaw. Away from a reader at the azimuth −90° is 90°.
    expect(Math.abs((await yaw)! + 90)).toBeLessThan(45);
    expect((await setup(page)).get("tilt_rate")).toBe(null);
    expect(complaints).toEqual([]);
  });

  test("where the browser must ask first, a button does, and goes away if the visitor refuses", async () => {
    const { page } = await visit({ ...PHONE, hash: "question" });
    await page.addInitScript(() => {
      const requestPermission = async () => "denied";
      Object.assign(DeviceOrientationEvent, { requestPermission });
    });
    await page.goto(page.url().replace("question", "your-turn"));
    await page.reload();
    await shown(page);
    expect(await hold(page).count()).toBe(0);
    await ask(page).click();
    await ask(page).waitFor({ state: "detached" });
  });

  test("there is no button on a computer without a sensor", async () => {
    const { page } = await visit({ hash: "your-turn" });
    await shown(page);
    await turn(page, null, null);
    expect(await page.locator(".telephone button").count()).toBe(0);
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
