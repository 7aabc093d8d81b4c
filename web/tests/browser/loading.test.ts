// The page comes quickly, from where it lies, and asks nobody else for anything.

import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { expect, test } from "vitest";
import { PAGE } from "../given/server";
import { address, browserForAll, leave, visit } from "./visit";

browserForAll();

const files = () => readdirSync(PAGE, { recursive: true }).map(String);

test("it loads without a complaint, from any folder, and from nowhere else", async () => {
  const visited = await visit({ webgl: true });
  await visited.page.getByRole("button", { name: "Let go" }).click();
  await visited.page.waitForTimeout(1000);
  expect(visited.complaints).toEqual([]);
  expect(visited.requests.length).toBeGreaterThan(2);
  const elsewhere = visited.requests.filter(
    (request) => !request.startsWith(address()) && !/^(data|blob):/.test(request),
  );
  expect(elsewhere).toEqual([]);
  await leave(visited);
});

test("all that it loads is at most 400 kB, gzipped", () => {
  const loaded = files().filter((name) => /\.(html|js|css|wasm|svg|png|woff2)$/.test(name));
  const sizes = loaded.map((name) => [name, gzipSync(readFileSync(join(PAGE, name))).length]);
  const all = sizes.reduce((sum, [, size]) => sum + Number(size), 0);
  expect(all, JSON.stringify(sizes)).toBeLessThanOrEqual(400_000);
});

test("the licences of the packages in it lie beside it", () => {
  const licences = readFileSync(join(PAGE, "licences.txt"), "utf8");
  for (const name of ["three", "uplot", "@preact/signals-core"]) expect(licences).toContain(name);
});

test("once loaded it needs no network", async () => {
  const visited = await visit({ webgl: true });
  const { page, complaints } = visited;
  await page.context().setOffline(true);
  await page.getByLabel("Body", { exact: true }).selectOption("coin");
  await page.getByRole("button", { name: "Let go" }).click();
  await page.getByRole("button", { name: /Flick it \d+ times/ }).click();
  await page.getByRole("button", { name: /Next/ }).first().click();
  await page.getByRole("button", { name: "Copy as Python" }).click();
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Download CSV" }).click(),
  ]);
  expect(readFileSync(await file.path(), "utf8")).toMatch(/^t,tilt,/);
  await page.waitForTimeout(1000);
  expect(complaints).toEqual([]);
  await leave(visited);
});
