import { expect, test } from "vitest";
import { INITIAL } from "../../src/setup/setup";
import { fromHash, toHash } from "../../src/setup/url";
import { Chance } from "../given/chance";
import { anySetup } from "../given/setups";

test("a link restores every set-up, to the last digit", () => {
  const chance = new Chance(1);
  for (let k = 0; k < 500; k++) {
    const setup = anySetup(chance);
    expect(fromHash(`#${toHash(setup)}`)).toEqual({ setup, refusals: [] });
  }
});

test("the initial set-up needs nothing in the link", () => {
  expect(toHash(INITIAL)).toBe("");
  expect(fromHash("")).toEqual({ setup: INITIAL, refusals: [] });
});

test("a link names only what differs", () => {
  expect(toHash({ ...INITIAL, body: "coin", tilt: 60.5 })).toBe("body=coin&tilt=60.5");
});

test("what was refused stays as it is initially, the rest is taken", () => {
  const { setup, refusals } = fromHash("#tilt=abc&gravity=1.62");
  expect(setup).toEqual({ ...INITIAL, gravity: 1.62 });
  expect(refusals).toEqual([{ field: "tilt", message: "Tilt is a number, not “abc”." }]);
});

test("names that no field has are passed over", () => {
  expect(fromHash("#utm_source=mail&constructor=1")).toEqual({ setup: INITIAL, refusals: [] });
});
