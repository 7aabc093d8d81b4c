// Writes a motion as CSV: one row for each solver step, in SI units and radians.

import type { Motion } from "../core/motion";
import type { Shaking } from "../floor/shaking";
import { digits } from "./digits";

/** Numbers have all their digits. The friction ratio of a body in the air is infinite and written as
 * `inf`, as in the files of `rimroll simulate`. On a floor that moves, the motion of the table follows. */
export function toCsv(motion: Motion, shaking?: Shaking): string {
  const moments = motion.samples(1);
  const ground = Object.entries(shaking?.at(moments.column("t")) ?? {});
  const columns = moments.names
    .map((name) => moments.column(name))
    .concat(ground.map(([, column]) => column));
  const names = [...moments.names, ...ground.map(([name]) => name)];
  const rows = Array.from({ length: moments.length }, (_, k) =>
    columns.map((column) => cell(column[k] as number)).join(","),
  );
  return [names.join(","), ...rows, ""].join("\n");
}

const cell = (value: number) => digits(value).replace("Infinity", "inf").replace("NaN", "nan");
