// What a gyroscope in the body would show.

import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { violations } from "../given/axe";
import { browserForAll, visit } from "../given/visit";

browserForAll();

test("its star and its rates are drawn, and its record can be saved", async () => {
  const { page, complaints } = await visit({ hash: "friction=0.2&sideways=0.02&duration=0.8" });
  const section = page.getByRole("region", { name: "A phone in the body" });
  const star = section.getByRole("img");
  expect(await star.getAttribute("aria-label")).toMatch(
    /up to 6 rad\/s\. The first turns of the ray: \d\d\.\d°/,
  );
  await page.locator("#plot-gyroscope").waitFor({ state: "attached" });
  // The bright part of the path grows with time.
  const past = () => star.locator(".past").getAttribute("d");
  const before = await past();
  await page.getByRole("button", { name: "To the next collision" }).click();
  expect((await past())!.length).toBeGreaterThan(before!.length);
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    section.getByRole("button", { name: "Save as phyphox CSV" }).click(),
  ]);
  expect(file.suggestedFilename()).toBe("rimroll-can_2007-phyphox.csv");
  expect(readFileSync(await file.path(), "utf8")).toMatch(
    /^# simulated by rimroll, not measured\n"Time \(s\)","Gyroscope x \(rad\/s\)"/,
  );
  await section.getByText("rimroll gyro rimroll-can_2007-phyphox.csv --body can_2007").waitFor();
  expect(await violations(page)).toEqual([]);
  expect(complaints).toEqual([]);
});
