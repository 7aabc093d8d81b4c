// What a visitor can send to somebody else: a link, a command, or HTML for a page or slides.

import { LAB } from "../part";
import { button, element } from "../elements";
import { say, words } from "../words/words";

/** Public address of the page, if VITE_RIMROLL_ADDRESS was set when it was built. */
const PUBLISHED = (import.meta.env["VITE_RIMROLL_ADDRESS"] as string | undefined) ?? "";

export interface ShareLink {
  kind: "link" | "command";
  text: string;
}

/** The link or command for the # part of the address and the address of the page. */
export function shareLink(hash: string, page: string, published = PUBLISHED): ShareLink {
  const address = published || (isPublic(page) ? page : "");
  if (address === "")
    return { kind: "command", text: "rimroll lab" + (hash === "" ? "" : ` --setup "${hash}"`) };
  const bare = address.replace(/#.*$/, "");
  return { kind: "link", text: `${bare}#${hash || LAB}` };
}

/** HTML that shows an address of the page in a frame of another page. A page that only this machine has must be copied to `lab/`
 * beside that page. */
export function frameCode(
  hash: string,
  title: string,
  page: string,
  published = PUBLISHED,
): { isLocal: boolean; text: string } {
  const address = published || (isPublic(page) ? page : "");
  const bare = address === "" ? "lab/index.html" : address.replace(/#.*$/, "");
  const [src, name] = [`${bare}#${hash}`, title].map(escaped);
  return {
    isLocal: address === "",
    text: `<iframe src="${src}" title="${name}" width="640" height="360" style="border: 0"></iframe>`,
  };
}

const escaped = (text: string) =>
  text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");

/** Whether other machines can open a page at its address. */
function isPublic(page: string): boolean {
  const { protocol, hostname } = new URL(page);
  const isHere = /^(localhost|.*\.localhost|127(\.\d+){3}|\[::1\]|0\.0\.0\.0|\[::\])$/.test(
    hostname,
  );
  return /^https?:$/.test(protocol) && !isHere;
}

// The HTML with which a teacher puts the page into a lesson's pages or slides.

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

// Copies a text to the clipboard, or selects it for the visitor to copy if that is not allowed.

export async function copyText(text: string, shownIn: HTMLElement): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    select(shownIn);
    return false;
  }
}

function select(place: HTMLElement): void {
  const details = place.closest("details");
  if (details) details.open = true;
  place.focus();
  if (place instanceof HTMLInputElement || place instanceof HTMLTextAreaElement) place.select();
  else getSelection()?.selectAllChildren(place);
}
