import { defineConfig } from "vitest/config";

export default defineConfig({
  // The page works from any folder of any server, so nothing is named from the root.
  base: "./",
  build: {
    target: "es2022",
    outDir: "../python/rimroll/page",
    emptyOutDir: true,
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  test: { include: ["tests/**/*.test.ts"] },
});
