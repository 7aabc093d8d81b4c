// A plot of angles of turn over the values of a slider, computed by the core, with the present value.

import type { Core, Theory } from "../core/core";
import { svgElement } from "../elements";
import { simulationInput } from "../setup/simulation_input";
import { INITIAL, type Setup } from "../setup/setup";
import { formatFixed } from "../format";
import { say, words } from "../words/words";

export interface Line {
  name: string;
  /** Name of a colour of the page. */
  colour: string;
  /** The first turn of the motion itself, or a limit of theory. */
  of: "turn" | keyof Theory;
  dashed?: boolean;
}

export interface Computed extends Line {
  /** Degrees, one for each value. */
  angles: number[];
}

/** Number of values through which a line is drawn. */
export const POINTS = 41;

const DEGREES = 180 / Math.PI;

/** The angles of each line for some set-ups. */
export function computeLines(
  core: Core,
  lines: readonly Line[],
  setups: readonly Partial<Setup>[],
): Computed[] {
  const inputs = setups.map((setup) => simulationInput(core, { ...INITIAL, ...setup }));
  const theories = inputs.map(({ body, start, contactLaw, options }) =>
    core.theory(body, start, contactLaw, options.gravity),
  );
  const turns = () =>
    inputs.map(({ body, start, contactLaw, options }) => {
      const [fall] = core.falls(body, contactLaw, options, [{ start, frictionScale: 1 }]);
      return Math.abs(fall?.turn ?? NaN);
    });
  return lines.map((line) => {
    const { of } = line;
    const angles = of === "turn" ? turns() : theories.map((theory) => theory[of]);
    return { ...line, angles: angles.map((angle) => angle * DEGREES) };
  });
}

const [WIDTH, HEIGHT] = [360, 120];
const [LEFT, RIGHT, TOP, BOTTOM] = [34, 8, 10, 96];

export class Curve {
  readonly root = svgElement("svg", {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    role: "img",
    class: "curve",
  });
  private readonly now = svgElement("path", { class: "now" });

  /** `include` are angles that it always contains, degrees. */
  constructor(lines: readonly Computed[], about: string, include: readonly number[] = []) {
    const all = [...include, ...lines.flatMap(({ angles }) => angles)].filter(Number.isFinite);
    const [least, most] = [Math.min(...all), Math.max(...all)];
    const room = Math.max(0.08 * (most - least), 1);
    const y = (angle: number) =>
      BOTTOM - ((BOTTOM - TOP) * (angle - least + room)) / (most - least + 2 * room);
    for (const tick of ticksBetween(least - room, most + room))
      this.root.append(
        svgElement("path", {
          class: "tick",
          d: `M${LEFT} ${y(tick).toFixed(1)}H${WIDTH - RIGHT}`,
        }),
        svgElement(
          "text",
          { x: LEFT - 4, y: (y(tick) + 4).toFixed(1), "text-anchor": "end" },
          `${tick}°`,
        ),
      );
    for (const { angles, colour, dashed = false } of lines) {
      const points = angles
        .map((angle, k) => ({ x: placeOf(k / (angles.length - 1)), angle }))
        .filter(({ angle }) => Number.isFinite(angle))
        .map(({ x, angle }) => `${x.toFixed(1)} ${y(angle).toFixed(1)}`);
      const path = svgElement("path", {
        class: dashed ? "dashed" : "line",
        d: `M${points.join("L")}`,
      });
      path.style.stroke = `var(--${colour})`;
      this.root.append(path);
    }
    let x = LEFT;
    for (const { name, colour } of lines) {
      const label = svgElement("text", { x, y: HEIGHT - 6, class: "name" }, `— ${name}`);
      label.style.fill = `var(--${colour})`;
      this.root.append(label);
      x += 14 + 6.2 * (widthOf(name) + 2);
    }
    this.root.append(this.now);
    const spoken = lines.map(({ name, angles }) => {
      const known = angles.filter(Number.isFinite);
      return say(words.essay.range, {
        label: name,
        from: degrees(known[0]),
        to: degrees(known.at(-1)),
      });
    });
    this.root.setAttribute("aria-label", `${about}: ${spoken.join("; ")}.`);
  }

  /** Marks a place along the slider, 0 to 1. */
  mark(part: number): void {
    this.now.setAttribute("d", `M${placeOf(part).toFixed(1)} ${TOP - 4}V${BOTTOM}`);
  }
}

/** The width of a text in letters; a Chinese character is twice as wide. */
const widthOf = (text: string) =>
  [...text].reduce((width, letter) => width + (letter > "\u2e7f" ? 2 : 1), 0);

const degrees = (angle = NaN) => `${formatFixed(angle, 1)}°`;

const placeOf = (part: number) => LEFT + part * (WIDTH - LEFT - RIGHT);

/** Three to six round values within a range. */
function ticksBetween(low: number, high: number): number[] {
  const step = [1, 2, 5, 10, 20, 50, 100].find((step) => (high - low) / step < 6) ?? 200;
  const first = Math.ceil(low / step) * step;
  return Array.from({ length: Math.floor((high - first) / step) + 1 }, (_, k) => first + k * step);
}
