// The essay: a visitor predicts, is surprised, and sees the contact point run round.

import type { Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { SCENES } from "../../src/essay/scenes";
import { violations } from "../given/axe";
import { browserForAll, elsewhere, goTo, visit } from "../given/visit";

browserForAll();

const section = (page: Page, id: string) => page.locator(`#${id}`);
const result = (page: Page, id: string) => section(page, id).locator(".result");
const part = (page: Page) => page.evaluate(() => document.documentElement.dataset["part"]);

describe("on a telephone", () => {
  test.each([
    [390, 844],
    [360, 740],
  ])(
    "%i by %i has the question and the button in the first view, and no answer",
    async (width, height) => {
      const { page, complaints, requests } = await visit({
        hash: "",
        viewport: { width, height },
        hasTouch: true,
        isMobile: true,
      });
      for (const place of [
        page.getByRole("heading", { name: "Where will it come up?" }),
        section(page, "question").getByRole("button", { name: "Let go" }),
        section(page, "question").getByLabel("Your guess"),
      ]) {
        const box = (await place.boundingBox())!;
        expect(box.y).toBeGreaterThanOrEqual(0);
        expect(box.y + box.height).toBeLessThanOrEqual(height);
      }
      const next = (await section(page, "slap-or-roll").locator("h2").boundingBox())!;
      expect(next.y).toBeGreaterThanOrEqual(height);
      expect(await result(page, "question").innerText()).toBe("");
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
      expect(complaints).toEqual([]);
      expect(elsewhere(requests)).toEqual([]);
    },
  );
});

test("one predicts, lets go, and reads how far beside the guess it came up", async () => {
  const { page, complaints } = await visit({ hash: "" });
  const guess = section(page, "question").getByLabel("Your guess");
  await guess.focus();
  for (let press = 0; press < 10; press++) await page.keyboard.press("ArrowRight");
  expect(await guess.getAttribute("aria-valuetext")).toBe("190°, 10° beyond straight across");
  await section(page, "question").getByRole("button", { name: "Let go" }).click();
  await result(page, "question")
    .getByText(/^You said 190°. It came up at 204°. That is 14° beyond your guess/)
    .waitFor();
  await page.getByRole("link", { name: "How can that be? Look closer" }).click();
  await page.waitForURL(/#slap-or-roll$/);
  await result(page, "slap-or-roll")
    .getByText(/ran round 203\.9°.*The can itself turned 0\.1°/)
    .waitFor();
  // The slider for the time follows the motion, and moves it.
  const time = section(page, "slap-or-roll").getByLabel("Time");
  await time.fill("1000");
  await expect
    .poll(() => time.getAttribute("aria-valuetext"))
    .toMatch(/ms after the smallest tilt$/);
  expect(complaints).toEqual([]);
});

test("each scene has an address, is alive there, and leads to the same motion in the lab", async () => {
  const { page, complaints } = await visit({ hash: "friction" });
  await expect.poll(() => section(page, "friction").locator(".table-stage").count()).toBe(1);
  for (const { id } of SCENES) {
    await page.evaluate((hash) => (location.hash = hash), id);
    await section(page, id).locator(".table-stage").waitFor({ state: "attached" });
    await expect.poll(() => new URL(page.url()).hash).toBe(`#${id}`);
    // One picture serves all scenes.
    expect(await page.locator("#essay .table-stage").count()).toBe(1);
  }
  await goTo(page, "friction");
  await page.waitForURL(/#friction$/);
  await section(page, "friction").getByRole("button", { name: "ice" }).click();
  await result(page, "friction").getByText("the rim slipped on the way").waitFor();
  await section(page, "friction").getByRole("link", { name: "Open this in the lab" }).click();
  await page.waitForURL(/friction=0\.03/);
  await page.locator("#friction-field").waitFor();
  expect(await page.locator("#friction-field").inputValue()).toBe("0.03");
  expect(await part(page)).toBe("lab");
  // Back leads to the scene.
  await page.goBack();
  await section(page, "friction").locator(".table-stage").waitFor({ state: "attached" });
  expect(await part(page)).toBe("essay");
  expect(complaints).toEqual([]);
});

test("what a control changes is said", async () => {
  const { page, complaints } = await visit({ hash: "hand", reducedMotion: "reduce" });
  const said = (id: string) => result(page, id).innerText();
  const change = async (id: string, act: () => Promise<unknown>) => {
    await goTo(page, id);
    const before = await said(id);
    await act();
    await expect.poll(() => said(id)).not.toBe(before);
  };
  await change("hand", () => page.locator("#hand-control").fill("0"));
  expect(await said("hand")).toMatch(/ran round 202\.4°.*gap under the rim fell to 7\.0\sµm/);
  await change("tall-and-flat", () => page.locator("#tall-and-flat-control").fill("0"));
  expect(await said("tall-and-flat")).toContain("The limit for this cylinder is 402.5°");
  await change("disks-and-coins", () => page.getByRole("button", { name: "Ring" }).click());
  await change("experiment", () => page.getByRole("button", { name: "Flick it 42 times" }).click());
  await result(page, "experiment")
    .getByText(/^Of 42 flicks, \d+ fell to the left/)
    .waitFor();
  await goTo(page, "left-out");
  const gap = section(page, "left-out").locator("dd.here").first();
  expect(await gap.innerText()).toMatch(/^1[34]0\sµm$/);
  await page.locator("#left-out-control").fill("0");
  await expect.poll(() => gap.innerText()).toMatch(/^\d+\snm$/);
  expect(complaints).toEqual([]);
});

test.each(["light", "dark"] as const)(
  "has no accessibility violations, %s",
  async (colorScheme) => {
    const { page } = await visit({ hash: "", colorScheme, viewport: { width: 1366, height: 768 } });
    for (const id of ["friction", "experiment", "left-out"]) await goTo(page, id);
    expect(await violations(page)).toEqual([]);
  },
);

test("with reduced motion nothing plays until the button is pressed", async () => {
  const { page } = await visit({ hash: "slap-or-roll", reducedMotion: "reduce" });
  const time = () => page.locator("#slap-or-roll-control").inputValue();
  const before = await time();
  await page.waitForTimeout(700);
  expect(await time()).toBe(before);
  await section(page, "slap-or-roll").getByRole("button", { name: "Let go" }).click();
  await expect.poll(time).not.toBe(before);
});

test("old links open the lab, and the essay and the lab lead to each other", async () => {
  const { page, complaints } = await visit({ hash: "body=coin&tilt=30" });
  expect(await page.locator("#tilt-field").inputValue()).toBe("30");
  expect(await section(page, "question").isVisible()).toBe(false);
  await page.getByRole("link", { name: "What is this?" }).click();
  await section(page, "question").locator(".table-stage").waitFor({ state: "attached" });
  expect(await page.locator("#lab").isVisible()).toBe(false);
  // The keys of the lab do nothing here.
  await page.keyboard.press(" ");
  await page.getByRole("link", { name: "The lab", exact: true }).click();
  await page.locator("#tilt-field").waitFor();
  expect(new URL(page.url()).hash).toBe("#lab");
  expect(await page.locator("#tilt-field").inputValue()).toBe("20");
  expect(complaints).toEqual([]);
});

test("on a telephone the answer leads to the explanation, and nothing is wider than the screen", async () => {
  const { page } = await visit({
    hash: "",
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    reducedMotion: "reduce",
  });
  const guess = page.locator("#question-control");
  await guess.press("End");
  await page.locator("#question").getByText("270°, 90° beyond straight across").waitFor();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  const box = (await guess.boundingBox())!;
  expect(box.x + box.width).toBeLessThanOrEqual(390);
  await page.locator("#question .go").tap();
  await page.getByText(/^You said 270°/).waitFor();
  await page.getByRole("link", { name: "How can that be? Look closer" }).tap();
  const title = page.locator("#slap-or-roll-title");
  await expect.poll(async () => (await title.boundingBox())!.y).toBeLessThan(100);
  const picture = (await page.locator("#slap-or-roll .place").boundingBox())!;
  expect(picture.y + picture.height).toBeLessThan(844);
});

test("the fit says which friction suits the paper's falls", async () => {
  const { page } = await visit({ hash: "experiment", reducedMotion: "reduce" });
  const scene = page.locator("#experiment");
  await scene.getByRole("button", { name: "Which friction fits?" }).click();
  const answer = await scene.getByText(/^A friction of 0\.\d+ fits best/).innerText();
  const friction = Number(/0\.\d+/.exec(answer)?.[0]);
  expect(friction).toBeGreaterThan(0.06);
  expect(friction).toBeLessThan(0.15);
});
