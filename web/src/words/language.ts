// The language of the page, which index.html chooses before anything is shown, and the visitor's way to
// write numbers in it.

export const LANGUAGES = ["en", "de", "es", "fr", "pt", "zh"] as const;
export type Language = (typeof LANGUAGES)[number];

const chosen = typeof document === "undefined" ? "en" : document.documentElement.lang;

export const LANGUAGE: Language = LANGUAGES.find((one) => one === chosen) ?? "en";

/** The region of a visitor who reads the language there, as Mexico's Spanish has decimal points. */
export const localeOf = (language: Language, wanted: readonly string[]): string =>
  wanted.find((one) => one === language || one.startsWith(`${language}-`)) ?? language;

const LOCALE = localeOf(LANGUAGE, typeof document === "undefined" ? [] : navigator.languages);

export interface NumberStyle {
  /** What stands before the decimals. */
  decimal: "." | ",";
  /** What separates a number from a percent sign. */
  percentGap: string;
}

export function numberStyle(locale: string): NumberStyle {
  const { decimal } = partsOf(new Intl.NumberFormat(locale), 1.5);
  const percent = new Intl.NumberFormat(locale, { style: "percent" }).formatToParts(0.5);
  const gap = percent.find(({ type, value }) => type === "literal" && value.trim() === "");
  return { decimal: decimal === "," ? "," : ".", percentGap: gap?.value ?? "" };
}

const partsOf = (format: Intl.NumberFormat, value: number): Record<string, string> =>
  Object.fromEntries(format.formatToParts(value).map(({ type, value: text }) => [type, text]));

export const NUMBERS: Readonly<NumberStyle> = numberStyle(LOCALE);
