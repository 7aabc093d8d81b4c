// A plugin that writes the licences of all parts of the page to a file beside it, as they require.

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import type { Plugin } from "vite";

const PROJECT = join(import.meta.dirname, "..");

/** `others` are packages in files of the page that are built apart. */
export function licences(file: string, others: readonly string[]): Plugin {
  return {
    name: "licences",
    apply: "build",
    generateBundle(_options, bundle) {
      const modules = Object.values(bundle).flatMap((output) =>
        output.type === "chunk" ? output.moduleIds : [],
      );
      // Style sheets count as modules here; no package contributes only styles.
      const folders = new Set(modules.map(packageOf).filter((folder) => folder !== undefined));
      const texts = [
        ["LICENSE", "LICENSE-MIT", "LICENSE-APACHE"].map((name) => read(PROJECT, name)).join("\n"),
        ...[...folders, ...others.map(folderOf)].sort().map(licenceOfPackage),
        ...crates().map(licenceOfCrate),
        read(import.meta.dirname, "licences/rust.txt"),
      ];
      this.emitFile({
        type: "asset",
        fileName: file,
        source: texts.join(`\n${"-".repeat(80)}\n\n`),
      });
    },
  };
}

/** The folder of the package of a module; undefined for the page's own modules. */
function packageOf(module: string): string | undefined {
  if (!module.includes("/node_modules/")) return undefined;
  let folder = dirname(module.replace(/^\0/, "").replace(/\?.*/, ""));
  // A package.json without a name only sets the module type of its folder.
  while (!existsSync(join(folder, "package.json")) || !described(folder).name)
    folder = dirname(folder);
  return folder;
}

const folderOf = (name: string) => join(import.meta.dirname, "node_modules", name);

const described = (folder: string): { name?: string; version?: string } =>
  JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));

function licenceOfPackage(folder: string): string {
  const { name, version } = described(folder);
  return `${name} ${version}\n\n${licenceIn(folder)}`;
}

interface Crate {
  name: string;
  version: string;
  authors: string[];
  manifest_path: string;
  /** Source of the crate; null for the project's own. */
  source: string | null;
}

/** Third-party crates that are compiled into the core. */
function crates(): Crate[] {
  const target = "wasm32-unknown-unknown";
  const cargo = (...asked: string[]) =>
    execFileSync("cargo", asked, { cwd: PROJECT, encoding: "utf8", maxBuffer: 2 ** 26 });
  const tree = ["--package=rimroll-wasm", `--target=${target}`, "--edges=normal,no-proc-macro"];
  // A line is “libm v0.2.16”; for the project's own crates the folder follows.
  const compiled = cargo("tree", ...tree, "--prefix=none").split("\n");
  const known = JSON.parse(
    cargo("metadata", "--format-version=1", `--filter-platform=${target}`),
  ) as { packages: Crate[] };
  return known.packages.filter(
    ({ name, version, source }) => source !== null && compiled.includes(`${name} v${version}`),
  );
}

function licenceOfCrate({ name, version, authors, manifest_path }: Crate): string {
  const by = authors.map((author) => author.replace(/ <.*/, "")).join(", ");
  return `${name} ${version}${by && `, by ${by}`}\n\n${licenceIn(dirname(manifest_path))}`;
}

/** The licence in a folder; the MIT licence if there is a choice. */
function licenceIn(folder: string): string {
  const found = readdirSync(folder).filter((entry) => /^licen[cs]e/i.test(entry));
  const file = found.find((entry) => /mit/i.test(entry)) ?? found[0];
  if (file === undefined) throw new Error(`${folder} has no licence file`);
  return read(folder, file);
}

const read = (folder: string, file: string) =>
  `${readFileSync(join(folder, file), "utf8").trim()}\n`;
