// The picture of the lab in the README, out/lab/readme.png: tools/picture_of_lab.sh takes it from there.

import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";
import { browserForAll, visit } from "./visit";

browserForAll();

const PICTURE = fileURLToPath(new URL("../../../out/lab/readme.png", import.meta.url));

test("just after the near-collision the contact point has run round by nearly the limit", async () => {
  const { page, complaints } = await visit({ webgl: true, colorScheme: "light" });
  await page.getByRole("button", { name: "To the next collision" }).click();
  // Frame by frame, without waiting for the pictures between.
  const turned = await page.getByRole("button", { name: "Next frame" }).evaluate((next) => {
    const degrees = () => Number.parseFloat(document.querySelector(".turned .big")!.textContent);
    for (let frame = 0; frame < 60 && degrees() < 201; frame++) (next as HTMLElement).click();
    return degrees();
  });
  expect(turned).toBeGreaterThan(201); // the limit is 202.29°
  // The label in the scene follows with the next picture.
  await page.getByText(/^contact ran round 20[12]\.\d°$/).waitFor();
  await page.mouse.move(0, 0); // so that no button is marked
  await page.screenshot({ path: PICTURE, timeout: 120_000 });
  expect(complaints).toEqual([]);
});
