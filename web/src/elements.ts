// Creates elements of the page in one expression each.

type Child = Node | string;
type Attributes = Record<string, string | number | boolean>;

/** Creates an HTML element with attributes (true sets one, false omits it) and children. */
export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  setAttributes(made, attributes);
  made.append(...children);
  return made;
}

/** Creates an SVG element with attributes and children. */
export function svgElement(
  tag: keyof SVGElementTagNameMap,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  setAttributes(made, attributes);
  made.append(...children);
  return made;
}

/** Creates a button with a text and an action. */
export function button(
  text: string,
  press: () => void,
  attributes: Attributes = {},
): HTMLButtonElement {
  const made = element("button", { type: "button", ...attributes }, text);
  made.addEventListener("click", press);
  return made;
}

function setAttributes(made: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes))
    if (value !== false) made.setAttribute(name, value === true ? "" : String(value));
}

// Icons of the buttons.

const SHAPES = {
  rewind: "M3 5h2.2v14H3zM13 5v14L5.4 12zM21.5 5v14l-8-7z",
  before: "M12 5v14L3 12zM21 5v14l-9-7z",
  back: "M14 5v14L5 12zM16.5 5H19v14h-2.5z",
  play: "M7 4.5v15L20 12z",
  pause: "M6.5 5h4v14h-4zM13.5 5h4v14h-4z",
  on: "M10 5v14l9-7zM5 5h2.5v14H5z",
  after: "M12 5v14l9-7zM3 5v14l9-7z",
  sound:
    "M4 9v6h4l5 5V4L8 9zM15.5 8.5a5 5 0 0 1 0 7l1.4 1.4a7 7 0 0 0 0-9.8zM18.4 5.6a9 9 0 0 1 0 12.8l1.4 1.4a11 11 0 0 0 0-15.6z",
  silence:
    "M4 9v6h4l5 5V4L8 9zM15 9.4 16.4 8 19 10.6 21.6 8 23 9.4 20.4 12 23 14.6 21.6 16 19 13.4 16.4 16 15 14.6 17.6 12z",
} as const;

export type Icon = keyof typeof SHAPES;

export function icon(name: Icon): SVGElement {
  return svgElement(
    "svg",
    { viewBox: "0 0 24 24", "aria-hidden": "true", focusable: "false" },
    svgElement("path", { d: SHAPES[name], fill: "currentColor" }),
  );
}
