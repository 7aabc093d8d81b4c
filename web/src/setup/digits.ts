/** A number with all its digits, and a zero with its sign, as Python and spreadsheets read it. */
export const digits = (value: number): string => (Object.is(value, -0) ? "-0.0" : String(value));
