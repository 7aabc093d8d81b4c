import { describe, expect, test } from "vitest";
import { allowed } from "../../fields";
import { formatExact } from "../../src/format";
import { FIELD_NAMES, type FieldName, FIELDS, MOTION_FIELDS } from "../../src/setup/fields";
import { read } from "../../src/setup/setup";
import { Chance } from "../given/chance";

const message = (...asked: Parameters<typeof read>) => {
  const result = read(...asked);
  return "message" in result ? result.message : undefined;
};

test("each field accepts what it begins with", () => {
  for (const name of FIELD_NAMES)
    expect(read(name, String(FIELDS[name].initial))).toEqual({ value: FIELDS[name].initial });
});

test("a slider stays inside what its field accepts", () => {
  for (const name of FIELD_NAMES) {
    const field = FIELDS[name];
    if (field.kind !== "number" || !field.slider) continue;
    for (const end of field.slider.slice(0, 2)) expect(message(name, String(end))).toBe(undefined);
  }
});

test.each(["12,5", " 12.5 ", "1.25e1", "+12.5"])("“%s” is twelve and a half", (text) => {
  expect(read("tilt", text)).toEqual({ value: 12.5 });
});

test.each(["0,125", "1,25", "1,0005"])("no thousands: “%s”", (text) => {
  expect(read("restitution", "0,125")).toEqual({ value: 0.125 });
  expect(message("tilt", text)).toBe(undefined);
});

test("a number is read as it is written in its field, to the last digit", () => {
  const chance = new Chance(3);
  for (let k = 0; k < 500; k++) {
    const value = chance.between(-1, 1) * 10 ** Math.round(chance.between(-20, 2));
    expect(read("tilt_rate", formatExact(value))).toEqual({ value });
  }
  expect(formatExact(9.80665001)).toBe("9.80665001");
  expect(formatExact(-1e-7)).toBe("−1e−7");
});

test.each([
  ["tilt", "20°", 20],
  ["tilt_rate", "−0.5 rad/s", -0.5],
  ["gravity", "1,62 m/s²", 1.62],
  ["fill", "30%", 30],
  ["length", "12 cm ", 12],
] as const)("%s takes “%s”, with its unit", (name, text, value) => {
  expect(read(name, text)).toEqual({ value });
});

test("another unit is no number", () => {
  expect(message("length", "12 mm")).toBe("Height must be a number, not “12 mm”.");
  expect(message("tilt", "°")).toBe("Tilt needs a number.");
});

/** A text that each field with a pattern accepts, and one that it refuses. */
const TEXTS: Partial<Record<FieldName, { accepted: string; refused: string }>> = {
  record: { accepted: "AAAA_-9z", refused: "AAA" },
  falls: { accepted: "12.5_0_360", refused: "12.5_" },
};

test("what `rimroll lab` checks a set-up by is what the page takes", () => {
  const table = allowed();
  expect(Object.keys(table)).toEqual([
    ...FIELD_NAMES,
    ...["speed", "slow", "view", "step"],
    ...MOTION_FIELDS.map((name) => `with.${name}`),
  ]);
  for (const name of FIELD_NAMES) {
    const entry = table[name]!;
    if ("choices" in entry) {
      for (const choice of entry.choices) expect(message(name, choice)).toBe(undefined);
      continue;
    }
    if ("pattern" in entry) {
      const { accepted, refused } = TEXTS[name]!;
      for (const text of ["", accepted, refused]) {
        const isRefused = text === refused;
        const refusal = `${FIELDS[name].label}: this is not a record of the page.`;
        expect(message(name, text)).toBe(isRefused ? refusal : undefined);
        expect(new RegExp(`^(${entry.pattern})$`).test(text)).toBe(!isRefused);
      }
      continue;
    }
    for (const end of [entry.min, entry.max])
      expect(message(name, String(end)) === undefined).toBe(!entry.open);
    expect(message(name, String(entry.max + 1))).toContain("is outside");
    const half = entry.min + 0.5;
    expect(message(name, String(half)) === undefined).toBe(!entry.whole);
  }
});

test("a minus sign is read like a hyphen", () => {
  expect(read("tilt_rate", "−2.5")).toEqual({ value: -2.5 });
});

describe("refusals have words", () => {
  test.each(["", " "])("nothing: “%s”", (text) => {
    expect(read("tilt", text)).toMatchObject({ field: "tilt", message: "Tilt needs a number." });
  });

  test.each(["abc", "1 2", "NaN", "twelve"])("no number: “%s”", (text) => {
    expect(message("tilt", text)).toBe(`Tilt must be a number, not “${text}”.`);
  });

  test.each(["0", "1e-300", "90", "-20", "Infinity"])("outside open bounds: %s", (text) => {
    expect(message("tilt", text)).toBe(
      `Tilt must be more than 0.000001° and less than 90°; ${text} is outside.`,
    );
  });

  test.each(["-0.1", "1.1"])("outside bounds: %s", (text) => {
    expect(message("restitution", text)).toBe(`Bounce must be from 0 to 1; ${text} is outside.`);
  });

  test.each(["1,000", "-12,500", "1,000,000"])("what may be thousands: %s", (text) => {
    expect(message("mass", text)).toBe(
      `Mass: “${text}” can be read in two ways; write a point before decimals and nothing between thousands.`,
    );
  });

  test("a refusal holds the text, to be corrected", () => {
    expect(read("tilt", " 95 ")).toMatchObject({ field: "tilt", text: " 95 " });
  });

  test("a unit that is a word stands apart", () => {
    expect(message("duration", "1000")).toContain("from 0.001 to 120 s; 1000 is outside.");
  });

  test.each(["teapot", "", "constructor"])("no such body: “%s”", (text) => {
    expect(message("body", text)).toBe(
      `Body: there is no “${text}”; choose The paper's can, Soda can, Beer bottle, Coin (1 euro), Ring, Battery (AA), Euler's disk, Your own or By its inertia.`,
    );
  });
});
