// What a visitor can take away: a link or a command, Python code for the same motion, and its numbers.

import { effect } from "@preact/signals-core";
import { button, element } from "../elements";
import type { Lab, Outcome } from "../lab";
import { toCsv } from "../setup/csv";
import { toPython } from "../setup/python";
import { hashOf } from "../setup/address";
import { copyText } from "./copy";
import { download } from "./download";
import { shareLink } from "./share_link";

export function mountShare(lab: Lab, place: HTMLElement): void {
  const message = element("p", { class: "done", role: "status" });
  const { help, label, name } = WORDS[linkFor(lab).kind];
  const link = element("input", { type: "text", id: "share-link", readonly: true });
  const code = element("pre", { id: "share-code", tabindex: 0, "aria-label": "Python code" });
  const copy = async (text: string, shownIn: HTMLElement, what: string) => {
    const done = await copyText(text, shownIn);
    say(message, done ? `${what} copied.` : "Selected: copy it with Ctrl+C or ⌘C.");
  };
  const copyLink = button(`Copy ${name.toLowerCase()}`, () => void copy(link.value, link, name));
  const copyCode = button("Copy as Python", () => void copy(code.textContent, code, "Python code"));
  const saveCsv = button("Download CSV", () => {
    lab.complete();
    const motion = lab.motion.value;
    if (!motion) return;
    const name = `rimroll-${lab.setup.value.body}.csv`;
    download(name, toCsv(motion, lab.shaking.value), "text/csv");
    say(message, `${name} downloaded, in SI units and radians.`);
  });
  place.append(
    element("h2", {}, "Share"),
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
    element("details", {}, element("summary", {}, "The same motion in Python"), code),
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

const WORDS = {
  link: {
    help: "The link holds the whole set-up. No server sees it.",
    label: "Link to this set-up",
    name: "Link",
  },
  command: {
    help: "The address of this page works only on your own machine. This command opens the same set-up wherever rimroll is installed.",
    label: "Command that opens this set-up",
    name: "Command",
  },
} as const;

const linkFor = (lab: Lab) => shareLink(hashOf(lab), location.href);

const pythonOf = (outcome: Outcome) =>
  "refused" in outcome ? `# There is no motion: ${outcome.refused}.\n` : toPython(outcome.input);

/** Shows a message; an emptied place makes screen readers read the same message again. */
function say(place: HTMLElement, text: string): void {
  place.textContent = "";
  setTimeout(() => (place.textContent = text), 50);
}
