import { expect, test } from "vitest";
import { posed } from "../../src/setup/posed";
import { toCsv } from "../../src/setup/csv";
import { INITIAL } from "../../src/setup/setup";
import { loadCore } from "../given/core";

test("a motion is a table of numbers with all their digits", async () => {
  const core = await loadCore();
  const { body, start, surface, options } = posed(core, INITIAL);
  const motion = core.simulate(body, start, surface, options);
  const [head, ...rows] = toCsv(motion).trimEnd().split("\n");
  const moments = motion.samples(1);

  expect(head?.split(",")).toEqual(moments.names);
  expect(rows.length).toBe(moments.length);
  for (const [k, name] of moments.names.entries()) {
    const column = rows.map((row) => Number(row.split(",")[k]));
    expect(column).toEqual([...moments.column(name)]);
  }
});
