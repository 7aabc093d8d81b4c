// What is sent to a friend works there.

import { describe, expect, test } from "vitest";
import { INITIAL_PACE } from "../../src/setup/pace";
import { fromHash, toHash } from "../../src/setup/url";
import { sent } from "../../src/share/sent";
import { Chance } from "../given/chance";
import { anySetup } from "../given/setups";

const HASH = "body=coin&tilt=60";

describe("a page that only this machine has", () => {
  test.each([
    "http://127.0.0.1:40519/#tilt=3",
    "http://localhost:8000/",
    "http://lab.localhost/",
    "http://[::1]:8000/page/",
    "http://0.0.0.0:8000/",
    "file:///home/me/page/index.html",
    "about:srcdoc",
  ])("gives a command: %s", (page) => {
    expect(sent(HASH, page, "")).toEqual({
      kind: "command",
      text: 'rimroll lab --setup "body=coin&tilt=60"',
    });
    expect(sent("", page, "").text).toBe("rimroll lab");
  });

  test("gives a link to where it is published, if it is", () => {
    const { kind, text } = sent(HASH, "http://127.0.0.1:40519/", "https://lab.example/can/");
    expect([kind, text]).toEqual(["link", "https://lab.example/can/#body=coin&tilt=60"]);
  });
});

test.each(["https://lab.example/~me/the%20can/?x=1", "http://192.168.1.7:8000/"])(
  "a page that others can reach gives its own link: %s",
  (page) => {
    expect(sent(HASH, `${page}#tilt=3`, "")).toEqual({ kind: "link", text: `${page}#${HASH}` });
    expect(sent("", page, "").text).toBe(page);
  },
);

test("a command says every set-up to any shell", () => {
  const chance = new Chance(3);
  for (let k = 0; k < 500; k++) {
    const setup = anySetup(chance);
    const { text } = sent(toHash(setup), "http://127.0.0.1:1/", "");
    // Nothing that a shell reads otherwise than it is written.
    const [, written] = /^rimroll lab --setup "([\w.=&-]+)"$/.exec(text) ?? [];
    expect(fromHash(`#${written}`)).toEqual({ setup, pace: INITIAL_PACE, refusals: [] });
  }
});
