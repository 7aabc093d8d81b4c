// The page's colours for a canvas, which cannot use custom properties.

import { type ReadonlySignal, signal } from "@preact/signals-core";

const NAMES = [
  "ground",
  "raised",
  "ink",
  "muted",
  "line",
  "accent",
  "theory",
  "warn",
  "plot-first",
  "plot-second",
  "plot-third",
  "plot-fourth",
  "plot-fifth",
  "rolling",
  "sliding",
  "flying",
  "ghost",
] as const;

export type Colour = (typeof NAMES)[number];
export type Palette = Readonly<Record<Colour, string>>;

/** The current colours, updated when the theme changes. */
export function paletteOf(place: HTMLElement): ReadonlySignal<Palette> {
  const palette = signal(read(place));
  const again = () => (palette.value = read(place));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", again);
  matchMedia("(prefers-contrast: more)").addEventListener("change", again);
  // A theme switch of the page would change an attribute of the root element.
  new MutationObserver(again).observe(document.documentElement, { attributes: true });
  return palette;
}

/** Reads computed colours from an element, because a custom property may hold an expression. */
function read(place: HTMLElement): Palette {
  const probe = place.appendChild(document.createElement("span"));
  const entries = NAMES.map((name) => {
    probe.style.color = `var(--${name})`;
    return [name, getComputedStyle(probe).color];
  });
  probe.remove();
  return Object.fromEntries(entries) as Palette;
}
