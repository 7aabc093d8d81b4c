import { defineConfig } from "vitest/config";
import { ALONE, aloneBuild, onlyScript, tablesAlone } from "./alone";
import { fields } from "./fields";
import { licences } from "./licences";
import { messages } from "./messages";
import { offline } from "./offline";
import { preview } from "./preview";
import { smallShaders } from "./shaders";

const FOLDER = "../python/rimroll/page";

export default defineConfig(({ mode }) => ({
  // Relative addresses let the page work from any folder of any server.
  base: "./",
  build: {
    target: "es2022",
    outDir: FOLDER,
    emptyOutDir: true,
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    cssCodeSplit: false, // one file, which rimroll.lab puts into its page
    chunkSizeWarningLimit: 1000, // kB, most of it three.js; the page in one script also has all languages
    ...(mode === ALONE && aloneBuild),
  },
  ...(mode === ALONE && { resolve: { alias: tablesAlone } }),
  plugins: [
    smallShaders(),
    messages(),
    ...(mode === ALONE
      ? [onlyScript()]
      : [
          licences("licences.txt", ["serwist"]),
          fields("setup.json"),
          preview(),
          offline(FOLDER, "offline.js"),
        ]),
  ],
  test: {
    // Run one browser at a time, because drawing in software uses all processors.
    fileParallelism: false,
    // Long limits for a busy machine; a passing test does not wait for them.
    testTimeout: 180_000,
    hookTimeout: 180_000,
    projects: [
      { extends: true, test: { name: "modules", include: ["tests/modules/**/*.test.ts"] } },
      {
        extends: true,
        test: {
          name: "browser",
          include: ["tests/browser/**/*.test.ts"],
          // Drawing in software on a busy machine may be too slow once; a test must not fail three times.
          retry: 2,
        },
      },
    ],
  },
}));
