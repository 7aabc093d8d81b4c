// Tags from which other sites make a preview of a link to the page. The address of a picture in them must
// be absolute.

import type { Plugin } from "vite";

/** Where the project publishes its page. */
const PUBLISHED = "https://rimroll.github.io/rimroll/lab/";

/** `address` is where the built page is published. */
export function preview(address = process.env["VITE_RIMROLL_ADDRESS"] || PUBLISHED): Plugin {
  const folder = new URL("./", address).href;
  const tags: Record<string, string> = {
    "og:type": "website",
    "og:url": folder,
    "og:title": "Where will it come up?",
    "og:description":
      "Tip a can and let it fall upright: it seems to rock, but its contact point runs round the rim. See it, slow it down, and try it yourself.",
    "og:image": `${folder}preview.png`,
    "og:image:width": "1200",
    "og:image:height": "630",
    "og:image:alt":
      "A transparent can just over a table: the gap under its rim is drawn magnified, and the contact point has run most of the way round.",
    "twitter:card": "summary_large_image",
  };
  return {
    name: "preview",
    transformIndexHtml: () =>
      Object.entries(tags).map(([property, content]) => ({
        tag: "meta",
        attrs: { property, content },
        injectTo: "head" as const,
      })),
  };
}
