// What can be sent to somebody else: a link, or where the page has no address that works elsewhere, a
// command.

/** Where the page is published, if it is: VITE_RIMROLL_ADDRESS when it was built. */
const PUBLISHED = (import.meta.env["VITE_RIMROLL_ADDRESS"] as string | undefined) ?? "";

export interface ShareLink {
  kind: "link" | "command";
  text: string;
}

/** For a set-up as it is in the address after #, and the page's own address. */
export function shareLink(hash: string, page: string, published = PUBLISHED): ShareLink {
  const address = published || (isPublic(page) ? page : "");
  if (address === "")
    return { kind: "command", text: "rimroll lab" + (hash === "" ? "" : ` --setup "${hash}"`) };
  const bare = address.replace(/#.*$/, "");
  return { kind: "link", text: bare + (hash === "" ? "" : `#${hash}`) };
}

/** Whether others than this machine find a page at its address. */
function isPublic(page: string): boolean {
  const { protocol, hostname } = new URL(page);
  const isHere = /^(localhost|.*\.localhost|127(\.\d+){3}|\[::1\]|0\.0\.0\.0|\[::\])$/.test(
    hostname,
  );
  return /^https?:$/.test(protocol) && !isHere;
}
