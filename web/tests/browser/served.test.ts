// The page from the server of `rimroll lab`, under its policy.

import { type ChildProcess, spawn } from "node:child_process";
import { once } from "node:events";
import { afterAll, beforeAll, expect, test } from "vitest";
import { PYTHON } from "../given/python";
import { browserForAll, emptyPage } from "../given/visit";

browserForAll();

let lab: ChildProcess;
let address: string;
beforeAll(async () => {
  const code = "import sys; from rimroll.cli import main; sys.exit(main(['lab', '--no-browser']))";
  lab = spawn(PYTHON, ["-u", "-c", code], { stdio: ["ignore", "pipe", "inherit"] });
  const [said] = (await once(lab.stdout!, "data")) as [Buffer];
  address = /http:[^\s#]+/.exec(said.toString())![0];
});
afterAll(() => lab.kill("SIGINT"));

test("starts, computes and shows all parts", async () => {
  const page = await emptyPage();
  const heard: string[] = [];
  page.on("pageerror", (error) => heard.push(String(error)));
  page.on("requestfailed", (request) => heard.push(request.url()));
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !/WebGL/.test(message.text()))
      heard.push(message.text());
  });
  const response = await page.goto(`${address}#tilt=25`);
  expect(response!.headers()["content-encoding"]).toBe("gzip");
  await page.getByRole("button", { name: "Let go" }).waitFor();
  expect(await page.locator("#tilt-field").inputValue()).toBe("25");
  await page.locator("#plots canvas").first().waitFor({ state: "attached" });
  await page.getByText("The floor: at rest").click();
  await page.getByLabel("A pulse").check();
  await page.getByText("The floor moves by up to").first().waitFor();
  // Its policy allows the worker that computes long motions.
  const still = page.locator(".ended").getByText("is still being computed");
  await page.evaluate(() => (location.hash = "body=coin"));
  await Promise.all([page.waitForEvent("worker"), still.waitFor()]);
  await still.waitFor({ state: "detached" });
  expect(heard).toEqual([]);
});
