// The held body in the three-dimensional picture, with a mouse and with keys.

import type { Locator, Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { type Visit, browserForAll, visit } from "../given/visit";

browserForAll();

// A small window, because drawing in software is slow.
const SMALL = { viewport: { width: 360, height: 740 }, webgl: true };

const value = async (page: Page, name: string) =>
  Number((await page.locator(`#${name}-field`).inputValue()).replace("−", "-"));

/** The values in the address once it holds some; it is written with a delay. */
async function address(page: Page, part: RegExp): Promise<URLSearchParams> {
  await page.waitForURL((url) => part.test(url.hash));
  return new URLSearchParams(new URL(page.url()).hash.slice(1));
}

/** Points at the body on the canvas and returns the place. */
async function pointAt(page: Page, canvas: Locator): Promise<{ x: number; y: number }> {
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  if (!box) throw new Error("the table is not visible");
  for (let part = 0.5; part > 0.2; part -= 0.05) {
    const place = { x: box.x + box.width / 2, y: box.y + part * box.height };
    await page.mouse.move(place.x, place.y);
    if (await canvas.evaluate((it) => it.classList.contains("over"))) return place;
  }
  throw new Error("the body is not in the middle of the table");
}

async function taken(hash: string, what: (visit: Visit, canvas: Locator) => Promise<void>) {
  const visited = await visit({ ...SMALL, hash: hash || "lab" });
  await what(visited, visited.page.locator("#scene canvas"));
  expect(visited.complaints).toEqual([]);
}

describe("with a mouse", () => {
  test("a body that is moved and then held is released at rest", async () => {
    // The tilt rate of an earlier flick must not remain.
    await taken("tilt_rate=-1", async ({ page }, canvas) => {
      const { x, y } = await pointAt(page, canvas);
      await page.mouse.down();
      await page.mouse.move(x + 20, y, { steps: 2 });
      await page.mouse.move(x + 40, y - 10, { steps: 2 });
      await page.waitForTimeout(500);
      const said = await page.locator("#verdict .said").innerText();
      await page.mouse.up();
      const set = await address(page, /yaw=/);
      expect(set.get("tilt_rate")).toBe(null);
      expect(Number(set.get("tilt"))).toBeGreaterThan(0);
      // The preview gave the angle of the motion that follows.
      const angle = /runs? round by (.*?)°/;
      const lean = `it leans by ${set.get("tilt")}° toward ${set.get("yaw")?.replace("-", "−")}°.`;
      expect(said).toContain(lean);
      expect(angle.exec(await page.locator("#verdict .said").innerText())?.[1]).toBe(
        angle.exec(said)?.[1],
      );
      expect(Math.abs(Number(set.get("yaw")))).toBeGreaterThan(5);
      expect(await value(page, "tilt_rate")).toBe(0);
      expect(await value(page, "tilt")).toBe(Number(set.get("tilt")));
      expect(await value(page, "yaw")).toBe(Number(set.get("yaw")));
    });
  });

  test("a body that is released in motion is flicked", async () => {
    await taken("", async ({ page }, canvas) => {
      const { x, y } = await pointAt(page, canvas);
      await page.mouse.down();
      // The hand moves 40 px in 60 ms and lets go, however slowly this machine draws.
      await canvas.evaluate(
        (it, { x, y }) => {
          const mouse = (kind: string, up: number) =>
            it.dispatchEvent(
              new PointerEvent(kind, {
                ...{ pointerId: 1, pointerType: "mouse", isPrimary: true, bubbles: true },
                ...{ buttons: kind === "pointerup" ? 0 : 1, clientX: x, clientY: y - up },
              }),
            );
          const begun = performance.now();
          for (let k = 1; k <= 5; k++) {
            while (performance.now() < begun + 12 * k);
            mouse("pointermove", 8 * k);
          }
          mouse("pointerup", 40);
        },
        { x, y },
      );
      const set = await address(page, /tilt_rate=/);
      expect(Math.abs(Number(set.get("tilt_rate")))).toBeGreaterThan(0.5);
      expect(await value(page, "tilt_rate")).toBe(Number(set.get("tilt_rate")));
      await page.mouse.up();
    });
  });

  test("dragging beside the body turns the view and changes no setting", async () => {
    await taken("", async ({ page }, canvas) => {
      const { x } = await pointAt(page, canvas);
      const box = await canvas.boundingBox();
      const y = (box?.y ?? 0) + 0.9 * (box?.height ?? 0);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 60, y, { steps: 3 });
      await page.mouse.up();
      await page.waitForTimeout(500);
      expect(new URL(page.url()).hash).toBe("#lab");
    });
  });
});

test("keys tip the body, let it go, and put it back", async () => {
  await taken("", async ({ page }, table) => {
    for (const key of ["+", "+", "-", "Enter"]) await table.press(key);
    expect((await address(page, /tilt=/)).get("tilt")).toBe("21");
    expect(await value(page, "tilt")).toBe(21);
    await page.getByRole("button", { name: "Pause" }).waitFor();

    await table.press("+");
    await table.press("Escape");
    await page.waitForTimeout(500);
    expect(new URL(page.url()).hash).toBe("#tilt=21&sideways=0.02&rolling=0.0001&duration=1.8");
    expect(await value(page, "tilt")).toBe(21);
  });
});
