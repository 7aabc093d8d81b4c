import { defineConfig } from "vitest/config";
import { ALONE, aloneBuild, onlyScript, tablesAlone } from "./alone";
import { fields } from "./fields";
import { licences } from "./licences";
import { messages } from "./messages";
import { offline } from "./offline";
import { preview } from "./preview";
import { smallShaders } from "./shaders";
import { Retries } from "./tests/given/retries";

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
    // Long limits for a busy machine; a passing test does not wait for them.
    testTimeout: 180_000,
    hookTimeout: 180_000,
    reporters: ["default", new Retries()],
    projects: [
      { extends: true, test: { name: "modules", include: ["tests/modules/**/*.test.ts"] } },
      {
        extends: true,
        test: {
          name: "browser",
          include: ["tests/browser/**/*.test.ts"],
          retry: 1,
          maxWorkers: 2,
          sequence: { groupOrder: 1 },
        },
      },
      {
        extends: true,
        test: {
          name: "drawn",
          include: ["tests/drawn/**/*.test.ts"],
          // Drawing in software on a busy machine may be too slow once.
          retry: 1,
          // One browser at a time, because drawing in software uses all processors.
          maxWorkers: 1,
          sequence: { groupOrder: 2 },
        },
      },
    ],
  },
}));
