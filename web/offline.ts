// Plugins that build the service worker with the list of the files that it keeps.

import { serwist } from "@serwist/vite";

/** `folder` is where the page is built; `file` is the service worker in it. */
export const offline = (folder: string, file: string) =>
  serwist({
    swSrc: "src/service_worker.ts",
    swDest: file,
    swUrl: `./${file}`,
    base: "./",
    scope: "./",
    globDirectory: folder,
    // Not the picture for previews, nor the licences.
    globPatterns: ["index.html", "assets/*", "*.webmanifest", "*icon*.png"],
    // Names of assets contain a hash of their content.
    dontCacheBustURLsMatching: /^assets\//,
    injectionPoint: "self.__SW_MANIFEST",
    rollupFormat: "iife",
  });
