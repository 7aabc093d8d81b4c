// Runs the page's Python code.

import { spawn } from "node:child_process";
import { text } from "node:stream/consumers";
import { fileURLToPath } from "node:url";

export const PYTHON = fileURLToPath(new URL("../../../.venv/bin/python", import.meta.url));
const RUN_CODE = fileURLToPath(new URL("run_code.py", import.meta.url));

/** The motion that a piece of code computed. */
export interface Ran {
  status: string;
  columns: Map<string, Float64Array>;
  printed: string;
}

/** What Python prints when it runs some code. */
export async function printed(code: string): Promise<string> {
  const python = spawn(PYTHON, ["-c", code], { stdio: ["ignore", "pipe", "inherit"] });
  return text(python.stdout);
}

/** Runs pieces of code one after the other. */
export async function run(codes: readonly string[]): Promise<Ran[]> {
  const python = spawn(PYTHON, [RUN_CODE], { stdio: ["pipe", "pipe", "inherit"] });
  python.stdin.end(JSON.stringify(codes));
  const lines = (await text(python.stdout)).trimEnd().split("\n");
  if (lines.length !== codes.length) throw new Error("Python did not run all of the code");
  return lines.map((line) => {
    const { status, columns, printed } = JSON.parse(line);
    return {
      status,
      columns: new Map(
        Object.entries<string>(columns).map(([name, doubles]) => [name, decoded(doubles)]),
      ),
      printed,
    };
  });
}

function decoded(doubles: string): Float64Array {
  const bytes = Uint8Array.from(Buffer.from(doubles, "base64"));
  return new Float64Array(bytes.buffer);
}

/** Describes the first difference between two tables, to the last bit; undefined if there is none. */
export function difference(
  one: ReadonlyMap<string, ArrayLike<number>>,
  other: ReadonlyMap<string, ArrayLike<number>>,
): string | undefined {
  if ([...one.keys()].join() !== [...other.keys()].join()) return "they have other columns";
  for (const [name, values] of one) {
    const others = other.get(name) as ArrayLike<number>;
    if (values.length !== others.length)
      return `${name} has ${values.length} and ${others.length} rows`;
    for (let k = 0; k < values.length; k++)
      if (!Object.is(values[k], others[k]))
        return `${name}[${k}] is ${hexadecimal(values[k])} and ${hexadecimal(others[k])}`;
  }
  return undefined;
}

function hexadecimal(value = NaN): string {
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, value);
  return `${value} (${bits.getBigUint64(0).toString(16).padStart(16, "0")})`;
}

/** Reads a number as Python writes it. */
const numberOf = (cell: string) => Number(cell.replace("inf", "Infinity").replace("nan", "NaN"));

/** The columns of a CSV file as the page writes it. */
export function columnsOf(csv: string): Map<string, Float64Array> {
  const [head = "", ...rows] = csv.trimEnd().split("\n");
  const cells = rows.map((row) => row.split(",").map(numberOf));
  return new Map(
    head.split(",").map((name, k) => [name, Float64Array.from(cells, (row) => row[k] as number)]),
  );
}
