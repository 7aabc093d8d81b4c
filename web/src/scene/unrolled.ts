// The rim and the table, unrolled: how far the contact point has run along each since the turn began. The
// two lengths differ by what the rim has slipped along itself.

import { element } from "../elements";
import type { Motion } from "../core/motion";
import type { Lab, TurnProgress } from "../lab";
import { MARK_PLACE } from "./bodies/mark";
import { MARKS } from "./gap";
import { formatSmall } from "./lengths";
import { say, words } from "../words/words";

/** Lengths in m. */
export interface Runs {
  /** How far the contact point has run along the rim and along the table, positive if the yaw grows. */
  rim: number;
  table: number;
  /** How far the rim has slipped over the table, in all directions. */
  slip: number;
}

/** The contact point's runs in a motion of a body with a radius, m. */
export class Path {
  private readonly times: Float64Array;
  /** Slip along the rim and in all directions, from the start of the motion. */
  private readonly along: Float64Array;
  private readonly slip: Float64Array;

  constructor(
    private readonly motion: Motion,
    private readonly radius: number,
  ) {
    const points = motion.curve();
    const columns = (["t", "slip_x", "slip_y", "yaw"] as const).map((name) => points.column(name));
    const [t, x, y, yaw] = columns as [Float64Array, Float64Array, Float64Array, Float64Array];
    const tangential = (k: number) => x[k]! * Math.sin(yaw[k]!) - y[k]! * Math.cos(yaw[k]!);
    this.times = t.slice();
    this.along = integral(t, tangential);
    this.slip = integral(t, (k) => Math.hypot(x[k]!, y[k]!));
  }

  /** The runs from one time to another, s. */
  between(from: number, to: number): Runs {
    const spin = (time: number) => this.motion.at([time]).moment(0).spin;
    const change = (values: Float64Array) =>
      interpolated(this.times, values, to) - interpolated(this.times, values, from);
    const rim = this.radius * (spin(from) - spin(to));
    return { rim, table: rim + change(this.along), slip: change(this.slip) };
  }
}

/** The integral of a function over time from the first point to each. */
function integral(t: Float64Array, of: (k: number) => number): Float64Array {
  const sums = new Float64Array(t.length);
  for (let k = 1; k < t.length; k++)
    sums[k] = sums[k - 1]! + ((t[k]! - t[k - 1]!) * (of(k - 1) + of(k))) / 2;
  return sums;
}

function interpolated(t: Float64Array, values: Float64Array, time: number): number {
  let [low, high] = [0, t.length - 1];
  if (high < 1 || time >= t[high]!) return values[high] ?? 0;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (t[middle]! <= time) low = middle;
    else high = middle;
  }
  const width = t[high]! - t[low]!;
  const part = width > 0 ? (time - t[low]!) / width : 0;
  return values[low]! + part * (values[high]! - values[low]!);
}

/** Distance from the bottom of the picture and from the labels above, px. */
const BELOW = 14;

export class Unrolled {
  readonly element = element("div", { class: "table-unrolled", role: "img" });
  private readonly strips = { table: strip("table"), rim: strip("rim") };
  private readonly slipped = element("span", { class: "slipped" });
  /** Its height, px, measured when it changes, because that costs a layout. */
  private height = 0;
  private path: Path | undefined;
  private followed: Motion | undefined;

  constructor(private readonly lab: Lab) {
    const { table, rim } = this.strips;
    this.element.append(element("p", {}, words.scene.unrolled, this.slipped), table.row, rim.row);
    new ResizeObserver(() => (this.height = this.element.offsetHeight)).observe(this.element);
  }

  /** Height of the strip at the bottom of the picture that it takes, px. */
  get taken(): number {
    return this.height > 0 ? this.height + BELOW : 0;
  }

  show(progress: TurnProgress | undefined, radius: number): void {
    const motion = this.lab.motion.peek();
    this.element.hidden = !motion || !progress;
    if (!motion || !progress) return;
    if (motion !== this.followed) {
      this.followed = motion;
      this.path = new Path(motion, radius);
    }
    const now = this.lab.clock.time.peek();
    const { start, turn, angle } = progress;
    const runs = this.path!.between(start, now);
    const sense = Math.sign(turn?.angle ?? angle) || 1;
    const whole = Math.max(1.05 * radius * Math.abs(turn?.angle ?? angle), Math.PI * radius);
    const spacing = (2 * Math.PI * radius) / MARKS / whole;
    const first = firstMark(motion.at([start]).moment(0).spin, sense) * (radius / whole);
    for (const name of ["table", "rim"] as const) {
      const { bar, length } = this.strips[name];
      bar.style.setProperty(
        "--run",
        String(Math.min(Math.max((sense * runs[name]) / whole, 0), 1)),
      );
      bar.style.setProperty("--spacing", String(spacing));
      bar.style.setProperty("--first", String(first % spacing));
      bar.style.setProperty("--marked", String(first));
      length.textContent = formatSmall(Math.max(sense * runs[name], 0));
    }
    this.slipped.textContent = slipOf(runs, radius);
    // While the motion plays, the description of its last stop stays.
    if (this.lab.clock.playing.peek() && this.element.hasAttribute("aria-label")) return;
    const [rim, table] = [runs.rim, runs.table].map((run) => formatSmall(Math.abs(run)));
    this.element.setAttribute(
      "aria-label",
      say(words.scene.runs, { rim: rim!, table: table!, slip: slipOf(runs, radius) }),
    );
  }
}

/** Angle (rad) round the rim from the contact point to the marked point, in the direction of the run. */
function firstMark(spin: number, sense: number): number {
  const angle = sense * (MARK_PLACE - (Math.PI - spin));
  return angle - 2 * Math.PI * Math.floor(angle / (2 * Math.PI));
}

function slipOf({ slip }: Runs, radius: number): string {
  // Below this the computed slip of a rolling body is rounding.
  return slip < 1e-9 * radius
    ? words.scene.noSlipYet
    : say(words.scene.slipped, { length: formatSmall(slip) });
}

function strip(name: "rim" | "table") {
  const bar = element("i", { class: name });
  const length = element("b");
  return {
    row: element("div", {}, element("span", {}, words.scene[name]), bar, length),
    bar,
    length,
  };
}
