// What a visitor can send to somebody else: a link, or a command if the page's address works only on this
// machine.

import { LAB } from "../part";

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
