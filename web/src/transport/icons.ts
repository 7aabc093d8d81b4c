// Icons of the buttons.

import { svgElement } from "../elements";

const SHAPES = {
  rewind: "M3 5h2.2v14H3zM13 5v14L5.4 12zM21.5 5v14l-8-7z",
  before: "M12 5v14L3 12zM21 5v14l-9-7z",
  back: "M14 5v14L5 12zM16.5 5H19v14h-2.5z",
  play: "M7 4.5v15L20 12z",
  pause: "M6.5 5h4v14h-4zM13.5 5h4v14h-4z",
  on: "M10 5v14l9-7zM5 5h2.5v14H5z",
  after: "M12 5v14l9-7zM3 5v14l9-7z",
} as const;

export type Icon = keyof typeof SHAPES;

export function icon(name: Icon): SVGElement {
  return svgElement(
    "svg",
    { viewBox: "0 0 24 24", "aria-hidden": "true", focusable: "false" },
    svgElement("path", { d: SHAPES[name], fill: "currentColor" }),
  );
}
