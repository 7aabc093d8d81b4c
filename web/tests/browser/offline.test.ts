// A published page opens without a network after the first visit; one from this machine leaves nothing behind.

import { expect, test } from "vitest";
import { browserForAll, visit } from "../given/visit";

browserForAll();

/** A name of this machine that browsers trust as they trust a published page. */
const PUBLISHED = "lab.localhost";

test("opens without a network, in any language and with the floor that moves", async () => {
  const { page, complaints } = await visit({ host: PUBLISHED });
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.context().setOffline(true);
  await page.reload();
  const lab = page.locator("#lab");
  await lab.getByRole("button", { name: "Let go" }).waitFor();
  await page.getByText("The floor: at rest").click();
  await page.getByLabel("A pulse").check();
  await page.getByText("The floor moves by up to").first().waitFor();
  await page.goto(`${page.url().split("#")[0]}?lang=en#lab`);
  await lab.getByRole("button", { name: "Let go" }).waitFor();
  expect(complaints).toEqual([]);
});

test("keeps nothing of a page that is served by this machine", async () => {
  const { page } = await visit();
  await page.waitForLoadState("load");
  expect(
    await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length),
  ).toBe(0);
});
