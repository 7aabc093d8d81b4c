// Links and commands that a visitor sends work elsewhere.

import { describe, expect, test } from "vitest";
import { INITIAL_PLAYBACK } from "../../src/setup/playback";
import { fromHash, toHash } from "../../src/setup/url";
import { frameCode, shareLink } from "../../src/share/links";
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
    expect(shareLink(HASH, page, "")).toEqual({
      kind: "command",
      text: 'rimroll lab --setup "body=coin&tilt=60"',
    });
    expect(shareLink("", page, "").text).toBe("rimroll lab");
  });

  test("gives a link to where it is published, if it is", () => {
    const { kind, text } = shareLink(HASH, "http://127.0.0.1:40519/", "https://lab.example/can/");
    expect([kind, text]).toEqual(["link", "https://lab.example/can/#body=coin&tilt=60"]);
  });
});

test.each(["https://lab.example/~me/the%20can/?x=1", "http://192.168.1.7:8000/"])(
  "a page that others can reach gives its own link: %s",
  (page) => {
    expect(shareLink(HASH, `${page}#tilt=3`, "")).toEqual({
      kind: "link",
      text: `${page}#${HASH}`,
    });
    expect(shareLink("", page, "").text).toBe(`${page}#lab`);
  },
);

test("a command passes every set-up through any shell", () => {
  const chance = new Chance(3);
  for (let k = 0; k < 500; k++) {
    const setup = anySetup(chance);
    const { text } = shareLink(toHash(setup), "http://127.0.0.1:1/", "");
    // The text has no characters that a shell treats specially.
    const [, written] = /^rimroll lab --setup "([\w.=&-]+)"$/.exec(text) ?? [];
    expect(fromHash(`#${written}`)).toEqual({ setup, playback: INITIAL_PLAYBACK, refusals: [] });
  }
});

describe("the code of a frame", () => {
  test("has the address of a page that others can reach", () => {
    const { isLocal, text } = frameCode(
      "embed/hand",
      'A "can" & <more>',
      "https://lab.example/#x",
      "",
    );
    expect(isLocal).toBe(false);
    expect(text).toBe(
      '<iframe src="https://lab.example/#embed/hand" title="A &quot;can&quot; &amp; &lt;more>" width="640" height="360" style="border: 0"></iframe>',
    );
  });

  test("has a copy of the page if this one works on this machine only", () => {
    const { isLocal, text } = frameCode("embed&tilt=3", "A can", "http://127.0.0.1:8000/", "");
    expect(isLocal).toBe(true);
    expect(text).toContain('src="lab/index.html#embed&amp;tilt=3"');
  });
});
