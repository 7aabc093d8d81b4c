// Numbers as they are read.

export { duration as shownTime } from "../time/words";

/** With so many digits and none that say nothing. */
export function shown(value: number, digits = 6): string {
  if (Number.isNaN(value)) return "–";
  return String(Number(value.toPrecision(digits))).replace(/^-/, "−");
}

/** With all its digits, as it is read again. */
export const written = (value: number): string => String(value).replaceAll("-", "−");

/** With a unit in front of which there is a space, if it is written with one. */
export function withUnit(value: string, unit: string): string {
  return unit === "" || unit === "°" || unit === "%" ? value + unit : `${value} ${unit}`;
}

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** As `shown`, very large and very small ones as powers of ten. */
export function shownWide(value: number, digits: number): string {
  const size = Math.abs(value);
  if (!Number.isFinite(value) || value === 0 || (size >= 1e-5 && size < 1e6)) {
    const text = shown(value, digits);
    if (text.includes("e")) return value.toFixed(6);
    return size >= 1e4 ? text.replace(/(\d)(?=(\d{3})+$)/g, "$1\u202f") : text;
  }
  const [mantissa = "", exponent = ""] = value.toExponential(digits - 1).split("e");
  const raised = [...exponent.replace("+", "")]
    .map((digit) => (digit === "-" ? "⁻" : RAISED[Number(digit)]))
    .join("");
  return `${mantissa.replace(/^-/, "−")} × 10${raised}`;
}

/** An angle in rad, shown in degrees with so many decimals; what rounds to zero has no sign. */
export function degrees(angle: number, decimals: number): string {
  if (Number.isNaN(angle)) return "–";
  const text = ((angle * 180) / Math.PI).toFixed(decimals);
  return `${Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−")}°`;
}
