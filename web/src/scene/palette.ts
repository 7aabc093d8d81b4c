// The page's colours for the scene.

export interface Palette {
  dark: boolean;
  ink: string;
  muted: string;
  raised: string;
  /** Colours of the three-dimensional table, and of the room's floor under a table that is shaken. */
  table: string;
  room: string;
  rolling: string;
  sliding: string;
  flying: string;
  wedge: string;
  theory: string;
  /** The second of two motions. */
  ghost: string;
}

export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  const color = (name: string, light: string, night: string) =>
    style.getPropertyValue(name).trim() || (dark ? night : light);
  return {
    dark,
    ink: color("--ink", "#1a2127", "#e7ecef"),
    muted: color("--muted", "#535e67", "#a4b0b9"),
    raised: color("--raised", "#ffffff", "#1a2127"),
    table: dark ? "#33404a" : "#d8c4a2",
    room: dark ? "#242c32" : "#c3c9c6",
    rolling: color("--rolling", "#0072b2", "#56b4e9"),
    sliding: color("--sliding", "#d55e00", "#f0883e"),
    flying: color("--flying", "#7a5bd0", "#b9a4ff"),
    wedge: dark ? "#f2b632" : "#e69f00",
    theory: color("--theory", "#009e73", "#2fc79a"),
    ghost: color("--ghost", "#a6337b", "#e58fc4"),
  };
}

/** Calls a function when the colour scheme changes between light and dark; what it returns ends that. */
export function onTheme(changed: () => void): () => void {
  const scheme = matchMedia("(prefers-color-scheme: dark)");
  scheme.addEventListener("change", changed);
  return () => scheme.removeEventListener("change", changed);
}
