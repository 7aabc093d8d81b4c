// The sound: off at first, turned on by a button that says its state, heard only while the motion plays.

import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { browserForAll, visit } from "../given/visit";

browserForAll();

/** Counts the parts of the sound that begin, and those that are stopped. */
async function listen(page: Page): Promise<void> {
  await page.evaluate(() => {
    const heard = { begun: 0, stopped: 0, loudest: 0 };
    Object.assign(globalThis, { heard });
    const { start, stop } = AudioBufferSourceNode.prototype;
    AudioBufferSourceNode.prototype.start = function (this: AudioBufferSourceNode, ...when) {
      heard.begun++;
      for (const sample of this.buffer!.getChannelData(0))
        heard.loudest = Math.max(heard.loudest, Math.abs(sample));
      start.apply(this, when as []);
    };
    AudioBufferSourceNode.prototype.stop = function (this: AudioBufferSourceNode, ...when) {
      heard.stopped++;
      stop.apply(this, when as []);
    };
  });
}

const heard = (page: Page) =>
  page.evaluate(
    () =>
      (globalThis as unknown as { heard: { begun: number; stopped: number; loudest: number } })
        .heard,
  );

test("in the lab", async () => {
  const { page, complaints, requests } = await visit();
  await listen(page);
  const sound = page.locator("#transport").getByRole("button", { name: "Sound" });
  expect(await sound.getAttribute("aria-pressed")).toBe("false");
  expect(requests.filter((one) => /speaker/.test(one))).toEqual([]);
  await page.getByRole("button", { name: "Let go" }).click();
  await page.waitForTimeout(300);
  expect((await heard(page)).begun).toBe(0);

  await sound.click();
  expect(await sound.getAttribute("aria-pressed")).toBe("true");
  await page.waitForFunction(
    () => (globalThis as never as { heard: { loudest: number } }).heard.loudest > 0.01,
  );
  expect(requests.filter((one) => /speaker/.test(one)).length).toBe(1);
  await page.getByRole("button", { name: "Pause" }).click();
  const paused = await heard(page);
  expect(paused.stopped).toBeGreaterThan(0);
  await page.waitForTimeout(300);
  expect((await heard(page)).begun).toBe(paused.begun);

  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForFunction(
    (begun) => (globalThis as never as { heard: { begun: number } }).heard.begun > begun,
    paused.begun,
  );
  await sound.click();
  expect(await sound.getAttribute("aria-pressed")).toBe("false");
  const off = await heard(page);
  await page.waitForTimeout(300);
  expect((await heard(page)).begun).toBe(off.begun);
  expect(complaints).toEqual([]);
});

test("in a scene of the essay", async () => {
  const { page } = await visit({ hash: "slap-or-roll" });
  await listen(page);
  const scene = page.locator("#slap-or-roll");
  await scene.getByRole("button", { name: "Sound" }).click();
  await scene.getByRole("button", { name: "Let go" }).click();
  await page.waitForFunction(
    () => (globalThis as never as { heard: { begun: number } }).heard.begun > 2,
  );
  // All buttons have the same state.
  for (const one of await page.getByRole("button", { name: "Sound", includeHidden: true }).all())
    expect(await one.getAttribute("aria-pressed")).toBe("true");
});

test("a browser without sound says so", async () => {
  const { page } = await visit();
  await page.evaluate(() => Object.assign(globalThis, { AudioContext: undefined }));
  const sound = page.locator("#transport").getByRole("button", { name: "Sound" });
  await sound.click();
  await page.locator('#transport [title="This browser cannot play sound"]').waitFor();
  expect(await sound.getAttribute("aria-pressed")).toBe("false");
});
