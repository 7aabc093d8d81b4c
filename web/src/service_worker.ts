// Keeps the files of the page, so that it also opens without a network. A newer page is fetched in the background and
// shown when all tabs with the old one are closed: each version loads its own files only.

import { type PrecacheEntry, Serwist } from "serwist";

/** The build writes the files of the page here. */
declare const self: { __SW_MANIFEST: PrecacheEntry[] };

new Serwist({
  precacheEntries: self.__SW_MANIFEST,
  // The language does not change which file it is.
  precacheOptions: { cleanupOutdatedCaches: true, ignoreURLParametersMatching: [/./] },
}).addEventListeners();
