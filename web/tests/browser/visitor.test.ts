// What a visitor does and how the page responds.

import type { Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { PUBLIC_HOST, type Visit, browserForAll, visit } from "../given/visit";

browserForAll();

const degreesIn = async (page: Page, place: string) =>
  Number.parseFloat(/[\d.]+/.exec(await page.locator(place).innerText())?.[0] ?? "");

/** The verdict of the page. */
const verdict = (page: Page) => page.locator("#verdict");

async function visited(hash: string, what: (visit: Visit) => Promise<void>): Promise<void> {
  const one = await visit({ hash: hash || "lab" });
  await what(one);
  expect(one.complaints).toEqual([]);
}

describe("a can let go", () => {
  // The sideways error is so small that the turn is at its limit.
  test.each([
    ["no_slip", "&law=no_slip", 202.287],
    ["frictionless", "&law=frictionless", 220.969],
    ["coulomb", "", 202.287],
  ])("turns as the theory says: %s", async (_law, law, limit) => {
    await visited(`tilt=10&sideways=0.000001&duration=0.5${law}`, async ({ page }) => {
      await page.getByRole("button", { name: "Let go" }).click();
      // The angle is final at the end of the first turn and drifts afterwards. The clock keeps running,
      // so the value that ends the wait is the one that is tested.
      const turned = await page.waitForFunction(
        (least) => {
          const shown = Number.parseFloat(
            document.querySelector(".turned .big")?.textContent ?? "",
          );
          return shown > least && shown;
        },
        limit - 0.1,
        { timeout: 150_000 },
      );
      expect(Math.abs(Number(await turned.jsonValue()) - limit)).toBeLessThan(0.1);
      expect(Math.abs((await degreesIn(page, ".theory .big")) - limit)).toBeLessThan(0.01);
      expect(Math.abs((await degreesIn(page, ".turned .note")) - limit)).toBeLessThan(0.1);
    });
  });
});

describe("a link", () => {
  test("restores what was set, in every control", async () => {
    const hash = "body=own&radius=3.5&length=9&wall=55&tilt=33&law=frictionless&gravity=1.62";
    await visited(hash, async ({ page }) => {
      await expectValues(page, {
        "#body-field": "own",
        "#radius-field": "3.5",
        "#radius-slider": "3.5",
        "#length-field": "9",
        "#wall-field": "55",
        "#tilt-field": "33",
        "#gravity-field": "1.62",
      });
      expect(await page.locator("#law-frictionless").isChecked()).toBe(true);
      expect(new URL(page.url()).hash).toBe(`#${hash}`);
      // The address of a page on this machine does not work elsewhere.
      expect(await page.getByLabel("Command that opens this set-up").inputValue()).toBe(
        `rimroll lab --setup "${hash}"`,
      );
    });
  });

  test("can be sent from a page that others can reach", async () => {
    const visited = await visit({ hash: "tilt=33", host: PUBLIC_HOST });
    const { page } = visited;
    expect(page.url()).toMatch(new RegExp(`^http://${PUBLIC_HOST}:`));
    expect(await page.getByLabel("Link to this set-up").inputValue()).toBe(page.url());
    await page.getByRole("button", { name: "Copy link" }).click();
    await page.getByText(/^(Link copied|Selected: copy it)/).waitFor();
    expect(visited.complaints).toEqual([]);
  });

  test("is a command on this machine, with all settings", async () => {
    await visited("", async ({ page }) => {
      const command = page.getByLabel("Command that opens this set-up");
      expect(await command.inputValue()).toBe("rimroll lab");
      await page.locator("#body-field").selectOption("coin");
      await page.waitForFunction(
        () => location.hash === "#body=coin&sideways=0.02&rolling=0.0001&duration=1.8",
      );
      await page.getByRole("button", { name: "Copy command" }).click();
      await page.getByText("Command copied.").waitFor();
      expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(
        'rimroll lab --setup "body=coin&sideways=0.02&rolling=0.0001&duration=1.8"',
      );
    });
  });

  test("follows what is set, and holds it when the page is loaded again", async () => {
    await visited("", async ({ page }) => {
      await page.locator("#tilt-field").fill("12,5");
      await page.locator("#tilt-field").press("Enter");
      await page.locator("#body-field").selectOption("coin");
      await page.waitForFunction(
        () => location.hash === "#body=coin&tilt=12.5&sideways=0.02&rolling=0.0001&duration=1.8",
      );
      await page.reload();
      await expectValues(page, { "#tilt-field": "12.5", "#body-field": "coin" });
      await page.getByRole("button", { name: "Reset", exact: true }).click();
      await page.waitForFunction(() => location.hash === "#lab");
    });
  });

  test("that is edited by hand is read", async () => {
    await visited("tilt=12", async ({ page }) => {
      await page.evaluate(() => (location.hash = "tilt=13"));
      await page.waitForFunction(
        () => (document.querySelector("#tilt-field") as HTMLInputElement).value === "13",
      );
    });
  });

  test("survives a jump to a part of the page", async () => {
    await visited("tilt=12&speed=0.02&slow=0", async ({ page }) => {
      await page.getByRole("link", { name: "Flicks" }).click();
      expect(await page.evaluate(() => document.activeElement?.id)).toBe("flicks");
      await page.evaluate(() => (location.hash = "plots"));
      await expectValues(page, { "#tilt-field": "12", "#transport select": "0.02" });
      expect(await page.getByLabel("Slow at the collision").isChecked()).toBe(false);
      expect(await page.locator(".refusal").allInnerTexts()).not.toContain("Flicks");
    });
  });
});

async function expectValues(page: Page, values: Record<string, string>): Promise<void> {
  for (const [place, value] of Object.entries(values))
    expect(await page.locator(place).inputValue(), place).toBe(value);
}

describe("impossible values are refused at their fields, in words", () => {
  test("from a link", async () => {
    await visited("tilt=1e-300&body=teapot&gravity=heavy&law=no_slip", async ({ page }) => {
      for (const [field, words] of [
        ["tilt", "Tilt must be more than 0.000001° and less than 90°"],
        ["body", "there is no “teapot”; choose The paper's can, "],
        ["gravity", "Gravity must be a number, not “heavy”."],
      ] as const) {
        expect(await page.locator(`#${field}-refusal`).innerText()).toContain(words);
        const described = await page.locator(`#${field}-field`).getAttribute("aria-describedby");
        expect(described).toContain(`${field}-refusal`);
      }
      expect(await page.locator("#law-no_slip").isChecked()).toBe(true);
    });
  });

  test("as a value is typed, until it is corrected", async () => {
    await visited("", async ({ page }) => {
      const [field, refusal] = [page.locator("#tilt-field"), page.locator("#tilt-refusal")];
      await field.fill("95");
      await field.press("Enter");
      expect(await refusal.innerText()).toContain("95 is outside");
      expect(await field.getAttribute("aria-invalid")).toBe("true");
      await field.fill("25");
      await field.press("Enter");
      await page.waitForFunction(() => /^#tilt=25&/.test(location.hash));
      expect(await refusal.innerText()).toBe("");
    });
  });
});

describe("a motion that ends early is explained", () => {
  test.each([
    ["face down", "sideways=0", /face down.*at once/is],
    [
      "Painlevé's paradox",
      "body=coin&tilt=60&tilt_rate=-10&sideways=0.5&friction=2.2",
      /Painlevé.*no unique answer/is,
    ],
    ["fallen over", "tilt_rate=-3", /falls over/i],
  ])("%s", async (_what, hash, words) => {
    await visited(hash, async ({ page }) => {
      expect(await verdict(page).innerText()).toMatch(words);
    });
  });
});

test("forty-two flicks are summarised in words and drawn as a histogram", async () => {
  await visited("tilt_rate=-5&sideways=0&law=no_slip", async ({ page }) => {
    await page.getByRole("button", { name: "Flick it 42 times" }).click();
    await page.waitForFunction(
      () => /fell|toppled/.test(document.querySelector("#flicks-said")?.textContent ?? ""),
      undefined,
      { timeout: 150_000 },
    );
    expect(await page.locator("#flicks figure svg").getAttribute("aria-describedby")).toBe(
      "flicks-said",
    );
    await page.getByRole("button", { name: "Clear" }).click();
    expect(await page.locator("#flicks-said").innerText()).toBe("");
    // The button has disappeared, but the focus has not.
    expect(await page.locator("#flicks .make:focus").count()).toBe(1);
  });
});

test("no mark of friction begins outside its panel", async () => {
  await visited("body=ring", async ({ page }) => {
    const left = async (place: string) => (await page.locator(place).boundingBox())!.x;
    expect(await page.locator(".needed button").innerText()).toBe("μ* 0.000");
    expect(await left(".needed button")).toBeGreaterThanOrEqual(await left("#friction-slider"));
  });
});

test("both humps are beside the story on a laptop, without scrolling", async () => {
  await visited("", async ({ page }) => {
    const story = page.getByRole("region", { name: "The story" });
    const falls = story.getByRole("img", {
      name: /^Angles of turn of the falls, from 195° to 230° in bars of 1°/,
    });
    expect(await falls.isVisible()).toBe(false);
    while (!/step 5 of 6/.test(await story.innerText()))
      await story.getByRole("button", { name: "Next step" }).click();
    await page.waitForFunction(() =>
      /^Of 42/.test(document.querySelector("#flicks-said")!.textContent),
    );
    const box = (await falls.boundingBox())!;
    expect(await page.evaluate(() => scrollY)).toBe(0);
    expect([box.y > 0, box.y + box.height < 768, box.height > 100]).toEqual([true, true, true]);
    for (const side of ["left", "right"])
      expect(await falls.locator(`.bar.${side}`).count()).toBeGreaterThan(3);
    expect(await falls.getAttribute("aria-label")).toMatch(
      /Of 42 flicks, \d+ fell to the left after/,
    );
    await story.getByRole("button", { name: "Next step" }).click();
    expect(await falls.isVisible()).toBe(false);
  });
});

test("the story goes through its six steps, each another set-up", async () => {
  await visited("", async ({ page }) => {
    const story = page.getByRole("region", { name: "The story" });
    const titles = new Set<string>();
    for (let step = 1; step <= 6; step++) {
      expect(await story.innerText()).toContain(`step ${step} of 6`);
      titles.add(await story.getByRole("heading").innerText());
      if (step < 6) await story.getByRole("button", { name: "Next step" }).click();
    }
    expect(titles.size).toBe(6);
    expect(await story.getByRole("button", { name: "Next step" }).isDisabled()).toBe(true);
    expect(await story.locator(".next:focus").count()).toBe(1);
  });
});

describe("a step of the story", () => {
  const stepOf = (page: Page) => page.locator("#story .where").innerText();

  test("has an address, and Back leads to the one before", async () => {
    await visited("", async ({ page }) => {
      const next = page.getByRole("button", { name: "Next step" });
      await next.click();
      await page.waitForURL(/#step=2$/);
      await next.click();
      await page.waitForURL(/#step=3$/);
      await page.locator("#tilt-field").fill("15");
      await page.locator("#tilt-field").press("Enter");
      await page.waitForURL(/#step=3&tilt=15&view=contact$/);
      await page.goBack();
      await page.waitForURL(/#step=2$/);
      await expectValues(page, { "#tilt-field": "5", "#transport select": "0.02" });
      expect(await stepOf(page)).toContain("step 2 of 6");
      await page.goBack();
      await page.waitForFunction(() => location.hash === "#lab");
      expect(await stepOf(page)).toContain("step 1 of 6");
      await page.goForward();
      await page.goForward();
      await expectValues(page, { "#tilt-field": "15" });
      expect(await stepOf(page)).toContain("step 3 of 6");
    });
  });

  test("is opened by a link, with what it shows", async () => {
    await visited("step=5", async ({ page }) => {
      expect(await stepOf(page)).toContain("step 5 of 6");
      await expectValues(page, { "#friction-field": "0.12" });
      expect(await page.getByLabel("Command that opens this set-up").inputValue()).toBe(
        'rimroll lab --setup "step=5"',
      );
      await page.getByText(/^Of 42 flicks/).waitFor();
    });
  });

  test("that there is not is refused in words", async () => {
    await visited("step=9", async ({ page }) => {
      await page.getByText("Step: there is no “9”; choose 1, 2, 3, 4, 5 or 6.").waitFor();
    });
  });
});

test("what the model leaves out is compared with the motion shown", async () => {
  await visited("body=can_2007", async ({ page }) => {
    const limits = page.getByRole("region", { name: "What this model leaves out" });
    expect(await limits.locator(".exceeded").count()).toBe(4);
    expect(await limits.innerText()).toMatch(/3\.5\sµm\s+Smaller than the unevenness of any rim/);
    await page.locator("#sideways-field").fill("0.1");
    await page.locator("#sideways-field").press("Enter");
    await limits.getByText("Larger than the unevenness of rim and table").waitFor();
    expect(await limits.locator(".exceeded").count()).toBe(1);
  });
});

test("the lab opens with a can that is within the limits of a fine rim; losses and unevenness can be chosen", async () => {
  await visited("", async ({ page }) => {
    const limits = page.getByRole("region", { name: "What this model leaves out" });
    expect(await limits.locator(".exceeded").count()).toBe(1);
    await limits.getByText("No larger than the unevenness of rim and table").waitFor();
    await limits.getByText("The gap stays wider than this unevenness").waitFor();
    await page.getByLabel("Unevenness of rim and table").selectOption("coarse");
    await expectValues(page, { "#rolling-field": "0.0001" });
    await page.getByText("More", { exact: true }).click();
    await page.getByRole("button", { name: "Rolling resistance: none, 0" }).click();
    await limits.getByText(/^A real can loses energy to sound/).waitFor();
    await page.locator("#sideways-field").fill("0.01");
    await page.locator("#sideways-field").press("Enter");
    await limits.getByText(/touch at several points for .*runs round \d+° of the 203°/).waitFor();
  });
});

test("falls of several groups are pooled through their links, counted and fitted", async () => {
  await visited("falls=213_210_218&tilt_rate=-5&sideways=0.02", async ({ page }) => {
    const flicks = page.getByRole("region", { name: "Forty-two flicks" });
    const typed = flicks.getByRole("textbox", { name: /^Where did your can fall/ });
    await flicks.getByText("Of 3 flicks, 3 fell to the left after 213.7° ± 4.0°").waitFor();
    await typed.fill("https://lab.example/#falls=142_145&tilt=20\n150");
    await flicks.getByRole("button", { name: "Add" }).click();
    await page.waitForURL(/falls=213_210_218_142_145_150$/);
    await flicks.getByText(/3 fell to the right after 214\.3°/).waitFor();
    await flicks.getByRole("button", { name: "Which friction fits?" }).click();
    await flicks.getByText(/^A friction of 0\.\d+ fits best/).waitFor();
    await typed.fill("left");
    await flicks.getByRole("button", { name: "Add" }).click();
    await flicks.getByText("Type numbers from 0 to 360").waitFor();
    await flicks.getByRole("button", { name: "Remove all" }).click();
    await page.waitForFunction(() => !location.hash.includes("falls"));
  });
});
