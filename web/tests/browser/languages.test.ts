// The page in each language: chosen by the visitor's setting or the address, complete, and not too long for its place.

import { fileURLToPath } from "node:url";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { LANGUAGES } from "../../src/words/language";
import { first } from "../given/soak";
import { TABLES } from "../given/tables";
import { violations } from "../given/axe";
import { addressOfPage, browserForAll, elsewhere, emptyPage, visit } from "../given/visit";

browserForAll();

const { en } = TABLES;

/** The one with the longest words, and the one with other letters, come first. */
const OTHERS = ["de", "zh", "es", "fr", "pt"] as const;

const pictured = (name: string) =>
  fileURLToPath(new URL(`../../../out/lab/${name}.png`, import.meta.url));

/** Texts of buttons, labels and headings that their places cut off. */
const cutOff = (page: Page) =>
  page.$$eval("button, label, summary, h2, h3, th, td, nav a, legend, output, select", (all) =>
    all
      .filter((one) => one.checkVisibility() && !one.closest(".unseen"))
      .filter((one) => one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0)
      .filter((one) => getComputedStyle(one).display !== "inline")
      .map((one) => `${one.tagName} ${one.textContent.trim().slice(0, 60)}`),
  );

test("each language is among these", () => {
  expect(["en", ...OTHERS].sort()).toEqual([...LANGUAGES].sort());
});

test.each(first(2, OTHERS))(
  "%s: the essay and the lab are in the visitor's language",
  async (language) => {
    const table = TABLES[language];
    for (const [hash, said] of [
      ["", table.prose["question.text"]],
      ["lab", table.controls.title],
    ] as const) {
      const options = { hash, locale: language, letGo: table.letGo };
      const { page, complaints, requests } = await visit({
        ...options,
        viewport: { width: 360, height: 740 },
      });
      expect(await page.evaluate(() => document.documentElement.lang)).toBe(language);
      expect(await page.title()).toBe(table.prose.title);
      await page.getByText(said, { exact: true }).filter({ visible: true }).first().waitFor();
      // Numbers and links inside a sentence are still there.
      if (hash === "") {
        const limit = page.locator("[data-number=limit]");
        expect(await limit.textContent()).toBe(language === "zh" ? "202.3°" : "202,3°");
      }
      expect(await page.locator("#foot a[href*=doi]").count()).toBe(1);
      // What is folded is shown, too.
      await page.$$eval("details", (all) => all.forEach((one) => (one.open = true)));
      // No text of English that the table has in other words remains.
      const english = [en.letGo, en.openLab, en.share.title, en.controls.title, en.loading];
      const shown = await page.evaluate(() => document.body.innerText);
      for (const text of english.filter((one) => one !== table.letGo && one.includes(" ")))
        expect(shown, text).not.toContain(text);
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(width, `${language} ${hash}`).toBeLessThanOrEqual(360);
      expect(await cutOff(page), `${language} ${hash}`).toEqual([]);
      await page.screenshot({ path: pictured(`${language}-${hash || "essay"}`), fullPage: true });
      expect(await violations(page)).toEqual([]);
      expect(complaints).toEqual([]);
      expect(elsewhere(requests)).toEqual([]);
    }
  },
);

test("the address chooses the language before the visitor's setting", async () => {
  const { page } = await visit({ hash: "", locale: "fr", query: "lang=de", letGo: "Loslassen" });
  expect(await page.evaluate(() => document.documentElement.lang)).toBe("de");
  // The links to other languages keep the place.
  await page.evaluate(() => (location.hash = "#friction"));
  await page.getByRole("link", { name: "English" }).click();
  await page.getByText("From ice to rubber").first().waitFor();
  expect(page.url()).toMatch(/\?lang=en#friction$/);
});

test("a visitor whose language the page does not have reads English", async () => {
  const { page, requests } = await visit({ hash: "", locale: "fi" });
  expect(await page.evaluate(() => document.documentElement.lang)).toBe("en");
  // English needs no table.
  expect(requests.filter((one) => /\/(de|es|fr|pt|zh)-/.test(one))).toEqual([]);
});

test("a page whose table is missing is in English", async () => {
  const page = await emptyPage();
  await page.route(/\/assets\/de-/, (route) => route.abort());
  await page.goto(`${addressOfPage()}?lang=de`);
  await page.getByRole("button", { name: "Let go" }).first().waitFor();
  expect(await page.evaluate(() => document.documentElement.lang)).toBe("en");
  expect(await page.getByText("Where will it come up?").first().isVisible()).toBe(true);
});
