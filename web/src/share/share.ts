// What a visitor can take away: a link or a command, Python code for the same motion, and its numbers.

import { effect } from "@preact/signals-core";
import { button, element } from "../elements";
import type { Lab, Outcome } from "../lab";
import { download, toCsv, toPython } from "../setup/export";
import { hashOf } from "../setup/address";
import { copyText, frameField, shareLink } from "./links";
import { say, words } from "../words/words";

export function mountShare(lab: Lab, place: HTMLElement): void {
  const message = element("p", { class: "done", role: "status" });
  const { share } = words;
  const { help, label, copy: copyLabel, copied } = share[linkFor(lab).kind];
  const link = element("input", { type: "text", id: "share-link", readonly: true });
  const code = element("pre", { id: "share-code", tabindex: 0, "aria-label": share.python });
  const copy = async (text: string, shownIn: HTMLElement, copied: string) => {
    const done = await copyText(text, shownIn);
    announce(message, done ? copied : share.select);
  };
  const copyLink = button(copyLabel, () => void copy(link.value, link, copied));
  const copyCode = button(
    share.copyPython,
    () => void copy(code.textContent, code, share.copiedPython),
  );
  const saveCsv = button(share.csv, () =>
    lab.whenComplete(() => {
      const motion = lab.motion.value;
      if (!motion) return;
      const name = `rimroll-${lab.setup.value.body}.csv`;
      download(name, toCsv(motion, lab.shaking.value), "text/csv");
      announce(message, say(share.saved, { name }));
    }),
  );
  place.append(
    element("h2", {}, share.title),
    element("p", { class: "help" }, help),
    element(
      "div",
      { class: "link" },
      element("label", { for: link.id, class: "unseen" }, label),
      link,
      copyLink,
    ),
    element("div", { class: "buttons" }, copyCode, saveCsv),
    message,
    frameField("share-frame", share.labTitle, () =>
      ["embed", hashOf(lab)].filter(Boolean).join("&"),
    ),
    element("details", {}, element("summary", {}, share.samePython), code),
  );
  effect(() => {
    link.value = linkFor(lab).text;
  });
  effect(() => {
    const outcome = lab.outcome.value;
    code.textContent = pythonOf(outcome);
    copyCode.disabled = saveCsv.disabled = "refused" in outcome;
  });
}

const linkFor = (lab: Lab) => shareLink(hashOf(lab), location.href);

const pythonOf = (outcome: Outcome) =>
  "refused" in outcome ? `# There is no motion: ${outcome.refused}.\n` : toPython(outcome.input);

/** Shows a message; an emptied place makes screen readers read the same message again. */
function announce(place: HTMLElement, text: string): void {
  place.textContent = "";
  setTimeout(() => (place.textContent = text), 50);
}
