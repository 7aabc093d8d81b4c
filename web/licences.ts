// A plugin that puts the licences of all packages in the page beside it, as these ask.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import type { Plugin } from "vite";

export function licences(file: string): Plugin {
  return {
    name: "licences",
    apply: "build",
    generateBundle(_options, bundle) {
      const modules = Object.values(bundle).flatMap((output) =>
        output.type === "chunk" ? output.moduleIds : [],
      );
      // uPlot's style sheet is its module, too; no package is in the page by its styles alone.
      const folders = new Set(modules.map(packageOf).filter((folder) => folder !== undefined));
      const source = [...folders]
        .sort()
        .map(licenceOf)
        .join(`\n${"-".repeat(80)}\n\n`);
      this.emitFile({ type: "asset", fileName: file, source });
    },
  };
}

/** The folder of the package that a module is from; none for the page's own. */
function packageOf(module: string): string | undefined {
  if (!module.includes("/node_modules/")) return undefined;
  let folder = dirname(module.replace(/^\0/, "").replace(/\?.*/, ""));
  // A package.json without a name only says how its folder is to be read.
  while (!existsSync(join(folder, "package.json")) || !described(folder).name)
    folder = dirname(folder);
  return folder;
}

const described = (folder: string): { name?: string; version?: string } =>
  JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));

function licenceOf(folder: string): string {
  const { name, version } = described(folder);
  const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
  if (file === undefined) throw new Error(`${name} comes without a licence`);
  return `${name} ${version}\n\n${readFileSync(join(folder, file), "utf8").trim()}\n`;
}
