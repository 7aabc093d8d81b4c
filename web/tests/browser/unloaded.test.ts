// A page that cannot load its parts says what to do.

import { pathToFileURL } from "node:url";
import { join } from "node:path";
import type { Frame, Page } from "playwright-core";
import { describe, expect, test } from "vitest";
import { PAGE } from "../given/server";
import { first } from "../given/soak";
import { TABLES } from "../given/tables";
import { addressOfPage, browserForAll, emptyPage } from "../given/visit";

browserForAll();

const said = (place: Page | Frame) => place.locator("#scene .loading");

test("opened from a file", async () => {
  const page = await emptyPage();
  await page.goto(`${pathToFileURL(join(PAGE, "index.html")).href}#lab`);
  await said(page).getByText("rimroll lab", { exact: true }).waitFor();
  expect(await said(page).innerText()).toMatch(/opened as a file.*web server/s);
});

/** A text as it is shown, where backquotes become code. */
const shown = (text: string) => text.replaceAll("`", "");

describe.each(first(3, ["de", "zh", "en", "es", "fr", "pt"] as const))(
  "in the language %s",
  (lang) => {
    const words = TABLES[lang].unloaded;
    const about = async (page: Page, text: string) => {
      await said(page).getByText(shown(text), { exact: true }).waitFor();
      expect(await said(page).locator("[lang]").getAttribute("lang")).toBe(lang);
    };

    test("from a file", async () => {
      const page = await emptyPage({ locale: lang });
      await page.goto(`${pathToFileURL(join(PAGE, "index.html")).href}#lab`);
      await about(page, words.file);
    });

    test("without its script, also if the address names the language", async () => {
      const page = await emptyPage();
      await page.route(/index-.*\.js$/, (route) => route.fulfill({ status: 404 }));
      await page.goto(`${addressOfPage()}?lang=${lang}#lab`);
      await about(page, words.failed.replace("{0}", words.missing));
    });

    test("in a browser without modules", async () => {
      const page = await emptyPage({ locale: lang });
      await page.addInitScript("delete HTMLScriptElement.prototype.noModule");
      // Such a browser skips the script.
      await page.route(/index-.*\.js$/, (route) =>
        route.fulfill({ contentType: "text/javascript", body: "" }),
      );
      await page.goto(`${addressOfPage()}#lab`);
      await about(page, words.failed.replace("{0}", words.old));
    });
  },
);

test("in a sandboxed frame", async () => {
  const page = await emptyPage();
  await page.setContent(`<iframe sandbox="allow-scripts" src="${addressOfPage()}#lab"></iframe>`);
  const frame = page.frames()[1] as Frame;
  await said(frame).getByText("allow-same-origin", { exact: true }).waitFor();
  expect(await said(frame).innerText()).toContain(addressOfPage());
});

test("when its script is missing on the server", async () => {
  const page = await emptyPage();
  await page.route(/index-.*\.js$/, (route) => route.fulfill({ status: 404 }));
  await page.goto(`${addressOfPage()}#lab`);
  await said(page).getByText("its script is missing").waitFor();
});

test("when its script fails", async () => {
  const page = await emptyPage();
  await page.route(/index-.*\.js$/, (route) =>
    route.fulfill({ contentType: "text/javascript", body: "this is no script" }),
  );
  await page.goto(`${addressOfPage()}#lab`);
  await said(page)
    .getByText(/SyntaxError/)
    .waitFor();
});

test("when its script loads slowly, until it is there", async () => {
  const page = await emptyPage();
  await page.clock.install();
  let send = () => {};
  const held = new Promise<void>((resolve) => (send = resolve));
  await page.route(/index-.*\.js$/, async (route) => {
    await held;
    await route.continue();
  });
  await page.goto(`${addressOfPage()}#lab`, { waitUntil: "commit" });
  await said(page).waitFor();
  expect(await said(page).innerText()).toBe("Loading…");
  await page.clock.fastForward(20_000);
  await said(page)
    .getByText(/taking long to load/)
    .waitFor();
  await page.clock.resume();
  send();
  await page.getByRole("button", { name: "Let go" }).waitFor();
  expect(await said(page).count()).toBe(0);
});

test("when only the picture is missing, and the rest works", async () => {
  const page = await emptyPage();
  await page.route(/picture-.*\.js$/, (route) => route.fulfill({ status: 404 }));
  await page.goto(`${addressOfPage()}#lab`);
  await page
    .locator("#scene")
    .getByText(/picture could not be loaded.*Reload the page/)
    .waitFor();
  expect(await page.locator(".theory .big").innerText()).toBe("202.29°");
});

test("but not when everything loads", async () => {
  const page = await emptyPage();
  await page.clock.install();
  await page.goto(`${addressOfPage()}#lab`);
  await page.getByRole("button", { name: "Let go" }).waitFor();
  await page.clock.fastForward(60_000);
  expect(await said(page).count()).toBe(0);
  expect(await page.locator("#lab").innerText()).not.toMatch(/reload it|could not load/i);
});
