// The motion as a table for a spreadsheet: one row a moment, SI units and radians.

import type { Motion } from "../core/motion";
import { digits } from "./digits";

/** At the steps of the solver, the numbers with all their digits. The infinite ratio of friction of a
 * body in the air is `inf`, as in the files that `rimroll simulate` writes. */
export function toCsv(motion: Motion): string {
  const moments = motion.samples(1);
  const columns = moments.names.map((name) => moments.column(name));
  const rows = Array.from({ length: moments.length }, (_, k) =>
    columns.map((column) => cell(column[k] as number)).join(","),
  );
  return [moments.names.join(","), ...rows, ""].join("\n");
}

const cell = (value: number) => digits(value).replace("Infinity", "inf").replace("NaN", "nan");
