// The build of the page as one script, which rimroll.lab puts into a page that needs no server. It leaves the
// rest of the page as it is: the style and the core are the same files.

import type { Plugin, UserConfig } from "vite";

/** The mode of this build: `vite build --mode alone`. */
export const ALONE = "alone";

export const aloneBuild: UserConfig["build"] = {
  emptyOutDir: false,
  rollupOptions: {
    input: "src/main.ts",
    output: { entryFileNames: "alone.js", inlineDynamicImports: true },
  },
};

/** The tables of all languages are in the script: see src/words/tables_alone.ts. */
export const tablesAlone = [{ find: "./tables", replacement: "./tables_alone" }];

/** Writes the script only. */
export function onlyScript(): Plugin {
  return {
    name: "only-script",
    apply: "build",
    enforce: "post",
    generateBundle(_options, bundle) {
      for (const [name, output] of Object.entries(bundle))
        if (output.type === "asset") delete bundle[name];
    },
  };
}
