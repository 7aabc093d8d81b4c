// Numbers as they are read.

/** With so many digits and none that say nothing. */
export function shown(value: number, digits = 6): string {
  if (Number.isNaN(value)) return "–";
  return String(Number(value.toPrecision(digits))).replace(/^-/, "−");
}

/** With a unit in front of which there is a space, if it is written with one. */
export function withUnit(value: string, unit: string): string {
  return unit === "" || unit === "°" || unit === "%" ? value + unit : `${value} ${unit}`;
}
