// Numbers in the prose of the essay. The page holds them as text, so that the prose is there before the core;
// the core then writes its own.

import type { Core } from "../core/core";
import { MEASURED } from "../falls/paper";
import { bodyOf, contactLawOf, simulationInput, startOf } from "../setup/simulation_input";
import { INITIAL, type Setup } from "../setup/setup";
import { factsOf } from "./words";
import { passageFrom } from "../verdict/passage";
import { SCENES } from "./scenes";
import { formatFixed } from "../format/numbers";

/** Every number of the prose by its name, as a text. */
export function numbersOf(core: Core): Record<string, string> {
  const setup: Setup = { ...INITIAL, ...SCENES[0]?.setup };
  const theoryOf = (part: Partial<Setup>) => {
    const all = { ...setup, ...part };
    return core.theory(bodyOf(core, all), startOf(all), contactLawOf(all), all.gravity);
  };
  const { body, start, contactLaw, options } = simulationInput(core, setup);
  const motion = core.simulate(body, start, contactLaw, options);
  const passage = passageFrom(motion, 0);
  motion.forget();
  if (!passage) throw new Error("the essay's can does not come down");
  const can = theoryOf({});
  const { time } = factsOf(passage, can, setup, 0);
  const flat = theoryOf({ body: "own", radius: 3, length: 0, wall: 0, base: 0, law: "no_slip" });
  const half = Math.abs(passage.angle) - Math.PI;
  return {
    aside: degrees(half, 0),
    time,
    limit: degrees(can.noSlip, 1),
    frictionless: degrees(can.frictionless, 1),
    needed: formatFixed(can.neededFriction, 2),
    disk: degrees(flat.noSlip, 1),
    "disk-beyond": degrees(flat.noSlip - 2 * Math.PI, 1),
    left: `${formatFixed(MEASURED.left.mean, 1)}°`,
    right: `${formatFixed(MEASURED.right.mean, 1)}°`,
  };
}

/** Writes the numbers into the elements that name them. */
export function writeNumbers(core: Core, place: HTMLElement): void {
  const numbers = numbersOf(core);
  for (const one of place.querySelectorAll<HTMLElement>("[data-number]"))
    one.textContent = numbers[one.dataset["number"] ?? ""] ?? "";
}

const degrees = (angle: number, decimals: number) =>
  `${formatFixed((angle * 180) / Math.PI, decimals)}°`;
