// The picture: the one of the README, the camera, the help, two motions, and the stills of the essay.

import { fileURLToPath } from "node:url";
import { describe, expect, test } from "vitest";
import { violations } from "../given/axe";
import { first } from "../given/soak";
import { browserForAll, goTo, visit } from "../given/visit";

browserForAll();

/** The picture of the lab in the README: tools/picture_of_lab.sh takes it from there. */
const PICTURE = fileURLToPath(new URL("../../../out/lab/readme.png", import.meta.url));

test("just after the near-collision the contact point has run round by nearly the limit", async () => {
  const { page, complaints } = await visit({ webgl: true, colorScheme: "light" });
  await page.getByRole("button", { name: "To the next collision" }).click();
  // Frame by frame, without waiting for the pictures between.
  const turned = await page.getByRole("button", { name: "Next frame" }).evaluate((next) => {
    const degrees = () => Number.parseFloat(document.querySelector(".turned .big")!.textContent);
    for (let frame = 0; frame < 60 && degrees() < 201; frame++) (next as HTMLElement).click();
    return degrees();
  });
  expect(turned).toBeGreaterThan(201); // the limit is 202.29°
  // The label in the scene follows with the next picture.
  await page.getByText(/^contact ran round 20[12]\.\d°$/).waitFor();
  await page.mouse.move(0, 0); // so that no button is marked
  await page.screenshot({ path: PICTURE, timeout: 120_000 });
  expect(complaints).toEqual([]);
});

describe("the help on the table can be read to its end", () => {
  const sizes = [
    [360, 740],
    [1000, 640],
    [1366, 768],
  ] as const;
  test.each(first(1, sizes))("at %i by %i", async (width, height) => {
    const { page } = await visit({ viewport: { width, height }, webgl: true });
    await page.locator(".table-help summary").press("Enter");
    const box = page.locator(".table-help-box");
    const edges = () =>
      page.evaluate(() => {
        const of = (selector: string) => document.querySelector(selector)!.getBoundingClientRect();
        const [stage, help] = [of(".table-stage"), of(".table-help-box")];
        const last = of(".table-help-box dd:last-child");
        return { stage: [stage.left, stage.top, stage.right, stage.bottom], help, last };
      });
    const { stage, help } = await edges();
    const [left, top, right, bottom] = stage as [number, number, number, number];
    expect(help.left).toBeGreaterThanOrEqual(left);
    expect(help.top).toBeGreaterThanOrEqual(top);
    expect(help.right).toBeLessThanOrEqual(right);
    expect(help.bottom).toBeLessThanOrEqual(bottom);
    await box.press("End");
    await page.waitForFunction(() => {
      const box = document.querySelector(".table-help-box")!;
      return box.scrollTop + box.clientHeight >= box.scrollHeight - 1;
    });
    const { last } = await edges();
    expect(last.bottom).toBeLessThanOrEqual(help.bottom);
    expect(last.top).toBeGreaterThanOrEqual(help.top);
    expect(await violations(page)).toEqual([]);
  });
});

/** Places of the labels before the view from above, in its first frame, and a second later. */
async function fromAbove(reducedMotion: "reduce" | "no-preference"): Promise<string[]> {
  const { page } = await visit({
    viewport: { width: 360, height: 740 },
    webgl: true,
    reducedMotion,
  });
  await page.waitForFunction(() => document.querySelector(".table-words .word:not([hidden])"));
  // Wait until the first frames have been drawn, because they delay the next one.
  await page.waitForTimeout(1000);
  return page.evaluate(async () => {
    const places = () =>
      [...document.querySelectorAll<HTMLElement>(".table-words .word:not([hidden])")]
        .map(({ style }) => style.transform)
        .join();
    const buttons = [...document.querySelectorAll("button")];
    const before = places();
    buttons.find(({ textContent }) => textContent === "From above")?.click();
    await new Promise(requestAnimationFrame);
    const first = places();
    await new Promise((passed) => setTimeout(passed, 1000));
    for (let k = 0; k < 2; k++) await new Promise(requestAnimationFrame);
    return [before, first, places()];
  });
}

test("the camera is above at once; otherwise it moves there smoothly", async () => {
  const [usual, first, later] = await fromAbove("reduce");
  expect(first).not.toBe(usual);
  expect(later).toBe(first);
  const [, setOut, arrived] = await fromAbove("no-preference");
  expect(arrived).not.toBe(setOut);
  expect(arrived).toBe(later);
});

const PAIR =
  "friction=0.03&sideways=0.02&duration=1&with.body=can_2007&with.friction=0.8&with.sideways=0.02&with.duration=1";

test.each([
  [360, 740, "dark"],
  [1366, 768, "light"],
] as const)("%i by %i, %s: the picture names both motions", async (width, height, colorScheme) => {
  const { page, complaints } = await visit({
    hash: PAIR,
    viewport: { width, height },
    colorScheme,
    webgl: true,
  });
  const seen = (text: RegExp) =>
    page.waitForFunction(
      (text) =>
        [...document.querySelectorAll<HTMLElement>(".table-words .word:not([hidden])")].some(
          ({ style, textContent }) =>
            style.visibility === "visible" && new RegExp(text).test(textContent),
        ),
      text.source,
    );
  await seen(/^A: contact ran round [\d.]+°$/);
  await seen(/^B: contact ran round [\d.]+°$/);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
    width,
  );
  const table = (await page.locator("#compare table").boundingBox())!;
  expect(table.width).toBeLessThanOrEqual(width);
  expect(await violations(page)).toEqual([]);
  expect(complaints).toEqual([]);
});

test("in a small frame a coin stands beside the can", async () => {
  const { page, complaints } = await visit({
    hash: "embed&sideways=0.02&duration=1&with.body=coin&with.sideways=0.02&with.duration=1",
    viewport: { width: 640, height: 360 },
    webgl: true,
  });
  await page.getByText(/^B: coin, drawn 5\.6 × as large as A$/).waitFor();
  expect(await page.locator("#compare").isVisible()).toBe(false);
  expect(complaints).toEqual([]);
});

test("a finger that swipes over the picture scrolls, and sets nothing", async () => {
  const { page } = await visit({
    hash: "",
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
    webgl: true,
  });
  const finger = await page.context().newCDPSession(page);
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", y = 0) =>
    finger.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: type === "touchEnd" ? [] : [{ x: 150, y }],
    });
  await page.waitForTimeout(1500); // until the first pictures are drawn
  await touch("touchStart", 400);
  for (let k = 1; k < 8; k++) await touch("touchMove", 400 - 25 * k);
  await touch("touchEnd");
  await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(40);
  expect(await page.locator("#question .in-lab").getAttribute("href")).not.toMatch(/tilt=/);
});

test("there is one graphics context, and none when the essay is left", async () => {
  const { page, complaints } = await visit({
    hash: "hand",
    webgl: true,
    reducedMotion: "reduce",
    viewport: { width: 420, height: 420 },
  });
  const drawn = () => page.locator("#essay canvas[data-engine]").count();
  await goTo(page, "friction");
  expect(await drawn()).toBe(1);
  // The scene that was left shows a still.
  const still = page.locator("#hand .still");
  await expect.poll(() => still.evaluate((it: HTMLCanvasElement) => it.width)).toBeGreaterThan(100);
  const opaque = await still.evaluate((it: HTMLCanvasElement) =>
    it
      .getContext("2d")!
      .getImageData(0, 0, it.width, it.height)
      .data.some((byte) => byte > 0),
  );
  expect(opaque).toBe(true);
  await page.evaluate(() => (location.hash = "lab"));
  await page.locator("#scene canvas[data-engine]").waitFor();
  expect(await drawn()).toBe(0);
  expect(complaints.filter((text) => !/Context Lost/i.test(text))).toEqual([]);
});
