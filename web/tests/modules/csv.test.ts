import { expect, test } from "vitest";
import { Moments, type Motion } from "../../src/core/motion";
import { simulationInput } from "../../src/setup/simulation_input";
import { toCsv } from "../../src/setup/export";
import { INITIAL } from "../../src/setup/setup";
import { loadCore } from "../given/core";

test("a motion is a table of numbers with all their digits", async () => {
  const core = await loadCore();
  const { body, start, contactLaw, options } = simulationInput(core, INITIAL);
  const motion = core.simulate(body, start, contactLaw, options);
  const [head, ...rows] = toCsv(motion).trimEnd().split("\n");
  const moments = motion.samples(1);

  expect(head?.split(",")).toEqual(moments.names);
  expect(rows.length).toBe(moments.length);
  for (const [k, name] of moments.names.entries()) {
    const column = rows.map((row) => Number(row.split(",")[k]));
    expect(column).toEqual([...moments.column(name)]);
  }
});

test("an infinite friction ratio is written as in Python", () => {
  const numbers = Float64Array.from([0, 0.5, 1, 0.3, Infinity, NaN]);
  const moments = new Moments(["t", "friction_ratio"], numbers);
  const motion = { samples: () => moments } as unknown as Motion;
  expect(toCsv(motion)).toBe("t,friction_ratio\n0,0.3\n0.5,inf\n1,nan\n");
});
