import { defineConfig } from "vitest/config";
import { fields } from "./fields";
import { licences } from "./licences";

export default defineConfig({
  // The page works from any folder of any server, so nothing is named from the root.
  base: "./",
  build: {
    target: "es2022",
    outDir: "../python/rimroll/page",
    emptyOutDir: true,
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 800, // kB: three.js by itself has most of it
  },
  plugins: [licences("licences.txt"), fields("setup.json")],
  test: {
    // One browser at a time: it draws in software and takes all processors by itself.
    fileParallelism: false,
    // Long enough for a machine with much else to do: nothing that passes waits for them.
    testTimeout: 180_000,
    hookTimeout: 180_000,
    projects: [
      { extends: true, test: { name: "modules", include: ["tests/modules/**/*.test.ts"] } },
      {
        extends: true,
        test: {
          name: "browser",
          include: ["tests/browser/**/*.test.ts"],
          // A busy machine that draws in software may be too late once; what fails three times is wrong.
          retry: 2,
        },
      },
    ],
  },
});
