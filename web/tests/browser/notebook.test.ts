// The lab in a notebook is a text in a frame: it loads nothing, and runs under a strict policy.

import { writeFileSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Frame, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { printed } from "../given/python";
import { browserForAll, emptyPage } from "../given/visit";

browserForAll();

// A policy of a notebook that shows cells in a view of its own, such as that of VS Code.
const POLICY =
  "default-src 'none'; script-src 'unsafe-inline' 'unsafe-eval'; style-src 'unsafe-inline'; img-src data:; connect-src https:";

const CODE = `
import numpy as np, rimroll as rr
start = rr.State(tilt="30 deg", tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
motion = rr.simulate(rr.Body(0.15, 0.03, 0.036, 2e-4, 1.6e-4), start, rr.NoSlip(), duration=1.0)
print(f"{np.degrees(motion.turns[0].angle):.2f}°")
shown = motion.lab(browser=False)
shown.save("FILE")
print(shown._repr_html_())
`;

let folder: string;
let cell: string;
let turn: string;
beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "rimroll-"));
  const code = CODE.replace("FILE", join(folder, "lab.html"));
  [turn = "", cell = ""] = (await printed(code)).split(/\n(.*)/s);
});
afterAll(() => rmSync(folder, { recursive: true }));

/** Opens a file and collects requests and complaints. */
async function opened(file: string): Promise<{ page: Page; heard: string[] }> {
  const page = await emptyPage();
  const heard: string[] = [];
  page.on("request", (request) => heard.push(request.url()));
  page.on("pageerror", (error) => heard.push(String(error)));
  // three.js says that there is no WebGL.
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !/WebGL/.test(message.text()))
      heard.push(message.text());
  });
  await page.goto(pathToFileURL(join(folder, file)).href);
  return { page, heard };
}

async function showsTheMotion(place: Page | Frame): Promise<void> {
  await place.getByRole("button", { name: "Let go" }).waitFor();
  expect(await place.locator("#radius-field").inputValue()).toBe("3");
  expect(await place.locator("#verdict").innerText()).toContain(`of ${turn}`);
  await place.locator("#tilt-field").fill("25");
  await place.locator("#tilt-field").press("Enter");
  await expect
    .poll(() => place.locator("#share-link").inputValue())
    .toMatch(/^rimroll lab --setup "body=inertia&.*tilt=25&/);
}

test("in a cell under a strict policy", async () => {
  writeFileSync(
    join(folder, "notebook.html"),
    `<!doctype html><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${POLICY}">${cell}`,
  );
  const { page, heard } = await opened("notebook.html");
  const frame = page.frames()[1] as Frame;
  await showsTheMotion(frame);
  await frame.getByRole("link", { name: "Plots" }).click();
  expect(await frame.locator("#plots").evaluate((plots) => plots === document.activeElement)).toBe(
    true,
  );
  await page.waitForTimeout(500); // longer than the page waits before it writes its address
  expect(heard.slice(1)).toEqual([]);
});

test("as a file", async () => {
  const { page, heard } = await opened("lab.html");
  await showsTheMotion(page);
  expect(await page.getByRole("link", { name: "Licences" }).getAttribute("href")).toMatch(/^blob:/);
  expect(heard.slice(1)).toEqual([]);
});
