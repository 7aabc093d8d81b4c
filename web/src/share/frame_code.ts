// The HTML with which a teacher puts the page into a lesson's pages or slides.

import { button, element } from "../elements";
import { say, words } from "../words/words";
import { copyText } from "./copy";
import { frameCode } from "./share_link";

/** A folded field with the code of a frame and a button that copies it. `hash` is the # part of what it shows, and is asked
 * for when the field is opened or copied. */
export function frameField(id: string, title: string, hash: () => string): HTMLElement {
  const { share } = words;
  const code = () => frameCode(hash(), title, location.href);
  const input = element("textarea", { id, readonly: true, rows: 2, "aria-label": share.frame });
  const said = element("p", { class: "done", role: "status" });
  const copy = button(share.copyFrame, () => {
    input.value = code().text;
    void copyText(input.value, input).then((done) => {
      said.textContent = done ? share.copiedFrame : share.select;
    });
  });
  const help = element("p", { class: "help" }, say(share.frameHelp, { isLocal: code().isLocal }));
  const details = element(
    "details",
    { class: "frame-code" },
    element("summary", {}, share.frame),
    help,
    element("div", { class: "link" }, input, copy),
    said,
  );
  details.addEventListener("toggle", () => (input.value = code().text));
  return details;
}
