// A plugin that makes the shaders of three.js smaller: without comments, indentation and spaces round operators.

import type { Plugin } from "vite";

/** A text of several lines, as three.js writes its shaders. */
const LINES = /"(?:[^"\\\n]|\\.)*\\n(?:[^"\\\n]|\\.)*"/g;

export function smallShaders(): Plugin {
  return {
    name: "small-shaders",
    apply: "build",
    transform: (code, id) =>
      id.includes("/three/build/")
        ? { code: code.replace(LINES, (text) => `"${small(text.slice(1, -1))}"`), map: null }
        : null,
  };
}

/** A text whose lines are separated by the two characters \n and indented by \t. */
export function small(text: string): string {
  const lines = text.split("\\n").map((line) =>
    line
      .replace(/\/\/.*/, "")
      .replace(/\\t/g, " ")
      .trim(),
  );
  const shorter = lines
    .filter((line) => line !== "")
    // A directive is a line of its own.
    .map((line) => (line.startsWith("#") ? `\\n${line}\\n` : `${packed(line)} `));
  // The text before or after this one may be a directive.
  const [begin, end] = [lines[0] === "" ? "\\n" : "", lines.at(-1) === "" ? "\\n" : ""];
  return `${begin}${shorter.join("")}${end}`
    .replace(/ *(\\n)+ */g, "\\n")
    .replace(/([;{},]) +/g, "$1");
}

/** “- -” and “+ +” must not become other operators. */
const packed = (line: string) =>
  line
    .replace(/\s*([*/=<>,;{}()?:&|])\s*/g, "$1")
    .replace(/([^+\-\s])\s*([+-])\s*(?=[^+\-\s])/g, "$1$2");
