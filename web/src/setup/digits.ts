/** Writes a number with all its digits, and −0 with its sign, as Python and spreadsheets read it. */
export const digits = (value: number): string => (Object.is(value, -0) ? "-0.0" : String(value));
