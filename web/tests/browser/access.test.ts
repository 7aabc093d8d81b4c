// The page is for everybody: with a keyboard alone, with a screen reader, without motion, without WebGL.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type axe from "axe-core";
import type { ElementHandle, Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { browserForAll, leave, visit } from "./visit";

browserForAll();

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

describe("axe finds nothing serious", () => {
  async function violations(page: Page): Promise<string[]> {
    await page.evaluate(AXE);
    const { violations } = await page.evaluate(() =>
      (window as unknown as { axe: typeof axe }).axe.run({ resultTypes: ["violations"] }),
    );
    return violations
      .filter(({ impact }) => impact === "serious" || impact === "critical")
      .flatMap(({ id, nodes }) =>
        nodes.map(({ html, any }) => `${id}: ${any[0]?.message} ${html}`),
      );
  }

  test.each(["light", "dark"] as const)("in the %s", { timeout: 90_000 }, async (colorScheme) => {
    const visited = await visit({ colorScheme, webgl: true });
    const { page } = visited;
    expect(await violations(page)).toEqual([]);
    // With all that can be opened or comes later: a refusal, falls, code.
    await page.evaluate(() => (location.hash = "body=own&tilt=200"));
    await page.locator("#tilt-refusal").filter({ hasText: "outside" }).waitFor();
    await unfold(page);
    await page.getByRole("button", { name: /Flick it/ }).press("Enter");
    expect(await violations(page)).toEqual([]);
    await leave(visited);
  });

  test("on a telephone", { timeout: 60_000 }, async () => {
    const visited = await visit({ viewport: { width: 360, height: 740 }, hasTouch: true });
    expect(await violations(visited.page)).toEqual([]);
    await leave(visited);
  });
});

/** Opens all that is folded away. */
async function unfold(page: Page): Promise<void> {
  for (const summary of await page.$$("details:not([open]) > summary"))
    if (await summary.isVisible()) await summary.press("Enter");
}

const CONTROLS =
  "a[href], button, input, select, textarea, summary, [tabindex]:not([tabindex='-1']), [role=slider]";

/** What can be used just now, but for radio buttons that are reached by arrows from the chosen one. */
async function usable(page: Page): Promise<ElementHandle<HTMLElement>[]> {
  const found: ElementHandle<HTMLElement>[] = [];
  for (const control of await page.$$(CONTROLS)) {
    const inUse = await control.evaluate((it) => {
      const { disabled = false, type, checked } = it as HTMLInputElement;
      const shown = it.checkVisibility({ visibilityProperty: true });
      return shown && !disabled && (type !== "radio" || checked);
    });
    if (inUse) found.push(control as ElementHandle<HTMLElement>);
  }
  return found;
}

describe("with the keyboard alone", () => {
  test(
    "every control is reached, shows that it has the focus, and is not covered",
    {
      timeout: 90_000,
    },
    async () => {
      const visited = await visit({ webgl: true });
      const { page } = visited;
      for (const summary of await page.locator("details:not([open]) > summary").all())
        await summary.press("Enter");
      const controls = await usable(page);
      expect(controls.length).toBeGreaterThan(30);
      for (const [k, control] of controls.entries())
        await control.evaluate((it, k) => it.setAttribute("data-tested", String(k)), k);

      await page.evaluate(() => {
        (document.activeElement as HTMLElement).blur();
        getSelection()?.removeAllRanges();
        scrollTo(0, 0);
      });
      const reached = new Set<number>();
      const complaints: string[] = [];
      for (let k = 0; k < controls.length + 10; k++) {
        await page.keyboard.press("Tab");
        const { which, name, marked, seen } = await page.evaluate(focused);
        if (which === undefined) continue;
        reached.add(which);
        if (!marked) complaints.push(`no focus to be seen: ${name}`);
        if (!seen) complaints.push(`covered: ${name}`);
      }
      for (const [k, control] of controls.entries())
        if (!reached.has(k))
          complaints.push(
            `not reached: ${await control.evaluate((it) => it.outerHTML.slice(0, 120))}`,
          );
      expect(complaints).toEqual([]);
      await leave(visited);
    },
  );

  test("sliders move, choices change, buttons are pressed", { timeout: 60_000 }, async () => {
    const visited = await visit();
    const { page } = visited;
    const hash = () => page.evaluate(() => location.hash);

    for (const slider of await page.locator("#controls input[type=range]:visible:enabled").all()) {
      const before = await slider.inputValue();
      await slider.press("ArrowRight");
      expect(Number(await slider.inputValue())).toBeGreaterThan(Number(before));
      await slider.press("ArrowLeft");
      expect(await slider.inputValue()).toBe(before);
    }
    await page.locator("#body-field").press("ArrowDown");
    await page.waitForFunction(() => /body=soda_can/.test(location.hash));
    await page.locator("#law-coulomb").press("ArrowDown");
    await page.waitForFunction(() => /law=no_slip/.test(location.hash));
    await page.getByRole("button", { name: "As at the start" }).press("Enter");
    await page.waitForFunction(() => location.hash === "");
    await page.getByRole("button", { name: "Friction of ice" }).press("Space");
    await page.waitForFunction(() => location.hash === "#friction=0.03");
    await page.getByRole("button", { name: "Copy link" }).press("Enter");
    await page.getByText("Link copied.").waitFor();
    expect(await page.evaluate(() => navigator.clipboard.readText())).toContain(await hash());
    expect(visited.complaints).toEqual([]);
    await leave(visited);
  });
});

/** About the element with the focus: which it is, whether that shows, whether it can be seen. */
function focused() {
  const it = document.activeElement as HTMLElement;
  const name = it.id || it.getAttribute("aria-label") || it.textContent?.trim() || it.outerHTML;
  const which = it.dataset["tested"];
  // The ring may be round what belongs to it, as a radio button's words.
  const label = it.closest("label");
  const ringed = [it, label, ...(label?.children ?? [])].some((place) => {
    if (!place) return false;
    const { outlineStyle, outlineWidth, boxShadow } = getComputedStyle(place);
    return (outlineStyle !== "none" && outlineWidth !== "0px") || boxShadow !== "none";
  });
  const box = (label ?? it).getBoundingClientRect();
  const [x, y] = [box.left + box.width / 2, box.top + Math.min(box.height / 2, 20)];
  const top = document.elementFromPoint(x, y);
  const seen = top !== null && (it.contains(top) || top.contains(it) || !!label?.contains(top));
  return { which: which === undefined ? undefined : Number(which), name, marked: ringed, seen };
}

describe("without WebGL", () => {
  test("the page says so, and everything else works", async () => {
    const visited = await visit({ webgl: false });
    const { page, complaints } = visited;
    expect(await page.getByRole("region", { name: "The table" }).innerText()).toMatch(/WebGL/);
    expect(await page.locator("#plots canvas").count()).toBeGreaterThan(0);
    expect(await page.locator(".theory .big").innerText()).toBe("202.29°");
    expect(complaints).toEqual([]);
    await leave(visited);
  });
});

test("nothing moves by itself for whoever asks for reduced motion", async () => {
  const visited = await visit({ reducedMotion: "reduce" });
  const { page } = visited;
  const moving = await page.evaluate(
    () => document.getAnimations().filter(({ playState }) => playState === "running").length,
  );
  expect(moving).toBe(0);
  const before = await page.locator(".turned .big").innerText();
  await page.waitForTimeout(500);
  expect(await page.locator(".turned .big").innerText()).toBe(before);
  await leave(visited);
});
