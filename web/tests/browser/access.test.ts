// Accessibility: keyboard only, screen readers, reduced motion, no WebGL.

import type { ElementHandle, Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { violations } from "../given/axe";
import { browserForAll, visit } from "../given/visit";

browserForAll();

describe("axe finds nothing serious", () => {
  test.each(["light", "dark"] as const)("in the %s", async (colorScheme) => {
    const visited = await visit({ colorScheme });
    const { page } = visited;
    expect(await violations(page)).toEqual([]);
    // Include everything that opens or appears later: a refusal, falls, code.
    await page.evaluate(() => (location.hash = "body=own&tilt=200"));
    await page.locator("#tilt-refusal").filter({ hasText: "outside" }).waitFor();
    await unfold(page);
    await page.getByRole("button", { name: /Flick it/ }).press("Enter");
    expect(await violations(page)).toEqual([]);
  });

  test("on a telephone, where nothing is wider than the screen", async () => {
    const hash = "body=own&sideways=0.02&law=no_slip&twist=0.25";
    const visited = await visit({ hash, viewport: { width: 360, height: 740 }, hasTouch: true });
    expect(await violations(visited.page)).toEqual([]);
    await unfold(visited.page);
    const wide = () => document.documentElement.scrollWidth;
    expect(await visited.page.evaluate(wide)).toBe(360);
  });
});

test("on a telephone a link leads to a part that the table does not cover, and marks suit a fingertip", async () => {
  const { page } = await visit({ viewport: { width: 360, height: 740 }, hasTouch: true });
  for (const part of ["controls", "flicks", "plots", "share"]) {
    await page.evaluate((part) => {
      document.querySelector<HTMLElement>(`a[href="#${part}"]`)?.click();
    }, part);
    // Scrolling is smooth.
    await page.waitForFunction((part) => {
      const edges = (id: string) => document.getElementById(id)!.getBoundingClientRect();
      const [below, top] = [edges("scene").bottom, edges(part).top];
      const last = scrollY + innerHeight >= document.documentElement.scrollHeight - 1;
      return top >= below && (top < below + 50 || last);
    }, part);
  }
  for (const mark of await page.$$(".marks button")) {
    const box = await mark.boundingBox();
    expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(24);
  }
});

/** Opens all folded details. */
async function unfold(page: Page): Promise<void> {
  for (const summary of await page.$$("details:not([open]) > summary"))
    if (await summary.isVisible()) await summary.press("Enter");
}

const CONTROLS =
  "a[href], button, input, select, textarea, summary, [tabindex]:not([tabindex='-1']), [role=slider]";

/** The usable controls, except radio buttons that are reached by arrow keys from the chosen one. */
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
    "every control can be reached, shows its focus, and is not covered",
    {
      timeout: 150_000,
    },
    async () => {
      const visited = await visit({ reducedMotion: "reduce" });
      const { page } = visited;
      await unfold(page);
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
        const { which, name, marked, seen, by } = await page.evaluate(focused);
        if (which === undefined) continue;
        reached.add(which);
        if (!marked) complaints.push(`no focus to be seen: ${name}`);
        if (!seen) complaints.push(`covered by ${by}: ${name}`);
      }
      for (const [k, control] of controls.entries())
        if (!reached.has(k))
          complaints.push(
            `not reached: ${await control.evaluate((it) => it.outerHTML.slice(0, 120))}`,
          );
      expect(complaints).toEqual([]);
    },
  );

  test("every slider moves, every field takes what is typed", async () => {
    const visited = await visit({ hash: "body=own", reducedMotion: "reduce" });
    const { page } = visited;
    await unfold(page);
    const named = async (kind: string) =>
      (await page.$$eval(`:is(#controls, #flicks) ${kind}`, (all) =>
        all.filter((it) => it.checkVisibility()).map((it) => it.id),
      )) as string[];

    const sliders = await named("input[type=range]");
    expect(sliders).toEqual(quantities.map((name) => `${name}-slider`));
    for (const id of sliders) {
      const [slider, field] = [
        page.locator(`#${id}`),
        page.locator(`#${id.replace("slider", "field")}`),
      ];
      const position = async () => Number(await slider.inputValue());
      await slider.press("Home");
      const least = await position();
      expect(least, id).toBe(Number(await slider.getAttribute("min")));
      await slider.press("ArrowRight");
      expect(await position(), id).toBeGreaterThan(least);
      await slider.press("ArrowLeft");
      expect(await position(), id).toBe(least);
      // The field beside it follows.
      const before = await field.inputValue();
      await slider.press("ArrowRight");
      await slider.press("ArrowRight");
      await page.waitForFunction(
        ([id, before]) => (document.getElementById(id) as HTMLInputElement).value !== before,
        [id.replace("slider", "field"), before] as const,
      );
    }

    const given = quantities.map((name, k) => {
      // These values are inside all bounds, and whole where needed.
      const value = ["flicks", "seed"].includes(name) ? 3 + k : (31 + k) / 64;
      return [name, String(value)] as const;
    });
    for (const [name, text] of given) {
      await page.locator(`#${name}-field`).press("ControlOrMeta+a");
      await page.keyboard.type(text);
      await page.keyboard.press("Enter");
      // The value is set in the next frame, and then all fields show it.
      await page.evaluate(twoFrames);
    }
    await page.waitForFunction(
      (all) => all.every((one) => location.hash.slice(1).split("&").includes(one)),
      given.map(([name, text]) => `${name}=${text}`),
    );
    expect(visited.complaints).toEqual([]);
  });

  test("choices change, buttons are pressed", async () => {
    const { page, complaints } = await visit();
    await page.locator("#body-field").press("ArrowDown");
    await page.waitForFunction(() => /body=soda_can/.test(location.hash));
    await page.locator("#law-coulomb").press("ArrowDown");
    await page.waitForFunction(() => /law=no_slip/.test(location.hash));
    await page.getByRole("button", { name: "Reset", exact: true }).press("Enter");
    await page.waitForFunction(() => location.hash === "#lab");
    await page.getByRole("button", { name: "Friction of ice" }).press("Space");
    await page.waitForFunction(() => /&friction=0\.03&/.test(location.hash));
    await page.getByRole("button", { name: "Copy command" }).press("Enter");
    await page.getByText("Command copied.").waitFor();
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(
      'rimroll lab --setup "sideways=0.02&friction=0.03&rolling=0.0001&duration=1.8"',
    );
    expect(complaints).toEqual([]);
  });

  test("playback is controlled", async () => {
    const { page, complaints } = await visit();
    const transport = page.locator("#transport");
    const time = async () => Number.parseFloat(await transport.locator("strong").innerText());
    const scrubber = page.getByLabel("Time shown");
    await scrubber.press("Shift+ArrowRight");
    const later = await time();
    expect(later).toBeGreaterThan(0);
    await scrubber.press("ArrowLeft");
    expect(await time()).toBeLessThan(later);

    const slow = page.getByLabel("Slow at the collision");
    await slow.press("Space");
    expect(await slow.isChecked()).toBe(false);
    const speed = page.getByLabel("Speed");
    await speed.press("ArrowDown");
    expect(await speed.inputValue()).toBe("0.5");

    await page.getByRole("button", { name: "To the next collision" }).press("Enter");
    await transport.getByText("at the collision", { exact: true }).waitFor();
    await page.getByRole("button", { name: "Back to the release" }).press("Enter");
    expect(await time()).toBe(0);
    await page.getByRole("button", { name: "Play", exact: true }).press("Enter");
    await page.getByRole("button", { name: "Pause" }).waitFor();
    await page.waitForFunction(
      () => Number.parseFloat(document.querySelector("#transport strong")?.textContent ?? "") > 0,
    );
    expect(complaints).toEqual([]);
  });

  test("plots zoom in and out", async () => {
    const { page, complaints } = await visit();
    const zoom = page.getByRole("group", { name: "Zoom" });
    const shown = page.locator("#plots .shown");
    const whole = await shown.innerText();
    for (const [nearer, back] of [
      ["Zoom in", "Zoom out"],
      ["Zoom in", "Whole motion"],
      ["This collision", "Whole motion"],
    ] as const) {
      await zoom.getByRole("button", { name: nearer }).press("Enter");
      expect(await shown.innerText()).not.toBe(whole);
      await zoom.getByRole("button", { name: back }).press("Enter");
      expect(await shown.innerText()).toBe(whole);
    }
    expect(complaints).toEqual([]);
  });
});

/** All quantities with a slider for the visitor's own body, in the order of the page. */
const quantities = [
  ...["radius", "length", "mass", "wall", "base"],
  ...["tilt", "tilt_rate", "sideways", "friction"],
  ...["twist", "yaw", "rolling", "restitution", "gravity", "duration"],
  ...["flicks", "unsteadiness", "seed"],
];

/** Waits for two frames. */
async function twoFrames(): Promise<void> {
  for (let k = 0; k < 2; k++) await new Promise(requestAnimationFrame);
}

/** Describes the element with the focus: its number, whether it shows the focus, whether it is visible. */
async function focused() {
  // Scrolling takes a frame or two.
  for (let k = 0; k < 2; k++) await new Promise(requestAnimationFrame);
  const it = document.activeElement as HTMLElement;
  const name = it.id || it.getAttribute("aria-label") || it.textContent?.trim() || it.outerHTML;
  const which = it.dataset["tested"];
  // The ring may be around a part of the control, such as the label of a radio button.
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
  const by = top?.closest("[id]")?.id ?? "being off the screen";
  return { which: which === undefined ? undefined : Number(which), name, marked: ringed, seen, by };
}

describe("without WebGL", () => {
  test("the page says so, and the rest works", async () => {
    const visited = await visit({ webgl: false });
    const { page, complaints } = visited;
    expect(await page.getByRole("region", { name: "The table" }).innerText()).toMatch(/WebGL/);
    // No large empty box is left.
    expect((await page.locator("#scene").boundingBox())!.height).toBeLessThan(120);
    expect(await page.locator("#plots canvas").count()).toBeGreaterThan(0);
    expect(await page.locator(".theory .big").innerText()).toBe("202.29°");
    expect(complaints).toEqual([]);
  });
});

describe("with reduced motion nothing moves by itself", () => {
  /** The summary of the flicks at once after pressing the button. */
  const summaryAtOnce = (page: Page) =>
    page.evaluate(() => {
      document.querySelector<HTMLElement>("#flicks .make")?.click();
      return document.querySelector("#flicks-said")?.textContent;
    });

  /** So few flicks are computed at once, also on a busy machine. */
  const FEW = "tilt_rate=-5&flicks=4";

  test("flicks are all shown at once; otherwise one by one", async () => {
    const still = await visit({ hash: FEW, reducedMotion: "reduce" });
    expect(await summaryAtOnce(still.page)).toMatch(/^Of 4 flicks/);
    const other = await visit({ hash: FEW, reducedMotion: "no-preference" });
    expect(await summaryAtOnce(other.page)).toMatch(/^Flicking/);
    await other.page.getByText(/^Of 4 flicks/).waitFor();
  });
});
