import { describe, expect, test } from "vitest";
import { INITIAL_PLAYBACK, SPEEDS, VIEWS } from "../../src/setup/playback";
import { BY_HAND, INITIAL } from "../../src/setup/setup";
import { fromHash, holdsSetup, toHash } from "../../src/setup/url";
import { Chance } from "../given/chance";
import { anySetup } from "../given/setups";

const NOTHING = { setup: INITIAL, playback: INITIAL_PLAYBACK, refusals: [] };

test("a link restores every set-up, to the last digit", () => {
  const chance = new Chance(1);
  for (let k = 0; k < 500; k++) {
    const setup = anySetup(chance);
    expect(fromHash(`#${toHash(setup)}`)).toEqual({
      setup,
      playback: INITIAL_PLAYBACK,
      refusals: [],
    });
  }
});

test("what the lab opens with needs nothing in the link", () => {
  expect(toHash(BY_HAND)).toBe("");
  for (const link of ["", "#lab", "#embed", "#utm_source=mail&constructor=1"])
    expect(fromHash(link), link).toEqual({ ...NOTHING, setup: BY_HAND });
});

// Links were sent while the lab opened with the initial set-up.
test.each([
  ["body=can_2007", {}],
  ["view=contact", {}],
  ["slow=0&speed=0.1", {}],
  ["tilt=12", { tilt: 12 }],
  ["with.body=coin", {}],
])("%s leaves the other quantities at their initial values", (link, changed) => {
  expect(fromHash(`#${link}`).setup).toEqual({ ...INITIAL, ...changed });
});

test("the initial set-up is named", () => {
  expect(toHash(INITIAL)).toBe("body=can_2007");
  expect(fromHash("body=can_2007")).toEqual(NOTHING);
});

test("a link names only what differs", () => {
  expect(toHash({ ...INITIAL, body: "coin", tilt: 60.5 })).toBe("body=coin&tilt=60.5");
});

test("a refused value keeps the initial one, and the other values are read", () => {
  const { setup, refusals } = fromHash("#tilt=abc&gravity=1.62");
  expect(setup).toEqual({ ...INITIAL, gravity: 1.62 });
  expect(refusals).toEqual([
    { field: "tilt", text: "abc", message: "Tilt must be a number, not “abc”." },
  ]);
});

test("unknown names are ignored", () => {
  expect(fromHash("#utm_source=mail&constructor=1&tilt=20")).toEqual(NOTHING);
});

test("the last value of a repeated name counts", () => {
  expect(fromHash("#tilt=abc&tilt=25")).toEqual({ ...NOTHING, setup: { ...INITIAL, tilt: 25 } });
  const { setup, refusals } = fromHash("#tilt=25&tilt=abc");
  expect(setup).toEqual(INITIAL);
  expect(refusals.map(({ text }) => text)).toEqual(["abc"]);
});

test.each(["#plots", "#flicks", "#share", "#controls"])("%s is a part of the page", (hash) => {
  expect(holdsSetup(hash)).toBe(false);
});

test.each(["", "#", "#tilt=12", "#slow=0"])("“%s” is about the set-up", (hash) => {
  expect(holdsSetup(hash)).toBe(true);
});

describe("the playback", () => {
  test.each(SPEEDS)("%d is in the link unless it is real time", (speed) => {
    for (const stretched of [true, false]) {
      const playback = { ...INITIAL_PLAYBACK, speed, stretched };
      expect(fromHash(toHash(INITIAL, playback))).toEqual({ ...NOTHING, playback });
    }
  });

  test.each(VIEWS)("the view %s is in the link unless it is the usual one", (view) => {
    const playback = { ...INITIAL_PLAYBACK, view };
    expect(toHash(INITIAL, playback)).toBe(view === "whole" ? "body=can_2007" : `view=${view}`);
    expect(fromHash(toHash(INITIAL, playback))).toEqual({ ...NOTHING, playback });
  });

  test("is written after the set-up", () => {
    const hash = toHash({ ...INITIAL, tilt: 5 }, { speed: 0.02, stretched: false, view: "below" });
    expect(hash).toBe("tilt=5&speed=0.02&slow=0&view=below");
  });

  test("is refused in words", () => {
    const { playback, refusals } = fromHash("#speed=0&slow=maybe&view=inside");
    expect(playback).toEqual(INITIAL_PLAYBACK);
    expect(refusals.map(({ message }) => message)).toEqual([
      "Speed: there is no “0”; choose real time, 1/2, 1/5, 1/10, 1/50, 1/100, 1/1000 or 1/10000.",
      "Slow at the collision: there is no “maybe”; choose on or off.",
      "View: there is no “inside”; choose whole, above, contact or below.",
    ]);
  });
});
