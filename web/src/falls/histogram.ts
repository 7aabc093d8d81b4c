// A histogram of the directions of fall on a ring, seen from above, with the limits of theory and the
// paper's measurements. The initial lean points down, toward the hand that flicks the body away from
// itself: straight ahead is up, and falls to the left of the hand are on the left.

import type { Theory } from "../core/core";
import { MEASURED, type Tally } from "./tally";
import { words } from "../words/words";

const BIN = 3; // degrees; divides 180, so that no bar has falls of both sides
const [INNER, OUTER] = [46, 92];

/** Turns to the right are counted in the other direction. */
const MEASURED_ROUND = [MEASURED.left, { ...MEASURED.right, mean: 360 - MEASURED.right.mean }];

export interface Shown {
  tally: Tally;
  theory: Theory | undefined;
  /** Whether the paper's measurements apply to this body. */
  measured: boolean;
}

/** The picture as the inside of an SVG with a viewBox of -100 -100 200 200. */
export function histogram({ tally, theory, measured }: Shown): string {
  return [
    `<circle r="${INNER}" class="ring"/>`,
    degreeMarks(),
    bars(tally.directions),
    ...limits(theory),
    ...(measured ? MEASURED_ROUND.map(({ mean, deviation }) => measuredArc(mean, deviation)) : []),
    `<path d="M0 12V30m-3.5 -5L0 33l3.5 -8" class="lean"/>`,
    `<text y="7" class="small">${words.flicks.initialLean}</text>`,
  ].join("");
}

function bars(directions: readonly number[]): string {
  const counts = new Map<number, number>();
  for (const d of directions) {
    const bin = Math.floor(d / BIN);
    counts.set(bin, (counts.get(bin) ?? 0) + 1);
  }
  const highest = Math.max(4, ...counts.values());
  return [...counts]
    .map(([bin, count]) => {
      const out = INNER + ((OUTER - INNER) * count) / highest;
      const side = bin * BIN >= 180 ? "left" : "right";
      return `<path class="bar ${side}" d="${sector(bin * BIN + 0.2, (bin + 1) * BIN - 0.2, INNER + 0.6, out)}"/>`;
    })
    .join("");
}

function limits(theory: Theory | undefined): string[] {
  if (!theory) return [];
  const lines: [number, string, string][] = [
    [theory.noSlip, LAW_COLOURS.no_slip, ""],
    [theory.frictionless, LAW_COLOURS.frictionless, "5 3"],
    [theory.here, "var(--theory)", "1.5 2"],
  ];
  return lines
    .filter(([limit]) => !Number.isNaN(limit))
    .flatMap(([limit, colour, dashes]) =>
      [limit, -limit].map((angle) => {
        const [from, to] = [point(deg(angle), INNER - 5), point(deg(angle), OUTER + 3)];
        return `<path d="M${from}L${to}" stroke="${colour}" stroke-dasharray="${dashes}" class="limit"/>`;
      }),
    );
}

/** A bar from one standard deviation below the mean to one above, and a dot at the mean. */
function measuredArc(mean: number, deviation: number): string {
  const radius = OUTER + 5;
  const [a, b] = [point(mean - deviation, radius), point(mean + deviation, radius)];
  const [x, y] = point(mean, radius).split(" ");
  return `<path d="M${a}A${radius} ${radius} 0 0 0 ${b}" class="measured"/><circle cx="${x}" cy="${y}" r="2.4" class="mean"/>`;
}

const degreeMarks = () =>
  [90, 180, 270]
    .map((d) => {
      const [x, y] = point(d, INNER - 11).split(" ");
      return `<path d="M${point(d, INNER - 3)}L${point(d, INNER)}" class="ring"/><text x="${x}" y="${y}" class="small">${d}°</text>`;
    })
    .join("");

/** A sector of a ring between two directions (degrees) and two radii. */
function sector(from: number, to: number, inner: number, outer: number): string {
  return `M${point(from, inner)}A${inner} ${inner} 0 0 0 ${point(to, inner)}L${point(to, outer)}A${outer} ${outer} 0 0 1 ${point(from, outer)}Z`;
}

/** The point in a direction, in degrees anticlockwise from the initial lean, which points down. */
function point(degrees: number, radius: number): string {
  const angle = (degrees * Math.PI) / 180;
  return `${(radius * Math.sin(angle)).toFixed(2)} ${(radius * Math.cos(angle)).toFixed(2)}`;
}

const deg = (radians: number) => (radians * 180) / Math.PI;

// Colours of the laws, which colour-blind readers can distinguish (Okabe and Ito).

export const LAW_COLOURS = {
  no_slip: "var(--law-no_slip)",
  frictionless: "var(--law-frictionless)",
} as const;
