// The near-collision close up. Marks stay at material points of the rim, posts under them show the gap
// between rim and table, magnified, and strips show the rim and the table unrolled. It is loaded when the
// camera first goes to the contact point or below the table.

import {
  BoxGeometry,
  CircleGeometry,
  Color,
  DoubleSide,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from "three";
import type { Lab, TurnProgress } from "../lab";
import { MARK_COLOUR, MARK_PLACE } from "./bodies/shapes";
import type { Instant, Layer } from "./instant";
import type { Labels } from "./labels";
import type { Palette } from "./palette";
import { lowestOf, type Pose } from "./pose";
import { formatSmall } from "./measures";
import { formatNumber } from "../format";
import { say, words } from "../words/words";
import { element } from "../elements";
import type { Motion } from "../core/motion";

/** Number of marks on the rim. */
export const MARKS = 24;
/** Radius of a mark and half the width of a post, in radii of the rim. */
const [MARK, POST] = [0.028, 0.011];
const SPACING = (2 * Math.PI) / MARKS;

export class Closeup implements Layer {
  readonly group = new Group();
  private readonly unrolled: Unrolled;
  /** A label at the highest point of the magnified rim. */
  private readonly label: number;
  private readonly marks = new InstancedMesh(
    new SphereGeometry(1, 12, 8),
    new MeshBasicMaterial({ toneMapped: false }),
    MARKS,
  );
  private readonly posts = new InstancedMesh(
    new BoxGeometry(2, 2, 1).translate(0, 0, 0.5),
    flat(1),
    MARKS,
  );
  private readonly rim = new Mesh(new TorusGeometry(1, 0.011, 8, 144), flat(1));
  private readonly base = new Mesh(new CircleGeometry(1, 96), flat(0.16));
  private readonly magnified = new Group();
  private readonly matrix = new Matrix4();
  private readonly spot = new Vector3();

  constructor(
    lab: Lab,
    stage: HTMLElement,
    private readonly labels: Labels,
  ) {
    this.label = labels.add("gap");
    this.unrolled = new Unrolled(lab);
    stage.append(this.unrolled.element);
    for (const mesh of [this.rim, this.base]) mesh.matrixAutoUpdate = false;
    for (const mesh of [this.marks, this.posts, this.rim, this.base]) mesh.frustumCulled = false;
    [this.base.renderOrder, this.posts.renderOrder, this.rim.renderOrder] = [7, 8, 9];
    this.magnified.add(this.base, this.posts, this.rim);
    this.group.add(this.marks, this.magnified);
    this.hide();
  }

  paint({ ink, rolling, raised }: Palette): void {
    const [mark, plain, even] = [MARK_COLOUR, rolling, raised].map((color) => new Color(color));
    for (let k = 0; k < MARKS; k++) {
      const color = k === 0 ? mark! : k % 2 ? plain! : even!;
      this.marks.setColorAt(k, color);
      this.posts.setColorAt(k, k === 0 ? mark! : plain!);
    }
    for (const mesh of [this.marks, this.posts]) mesh.instanceColor!.needsUpdate = true;
    this.rim.material.color.set(ink);
    this.base.material.color.set(rolling);
  }

  update(instant: Instant): void {
    if (instant.seeThrough) this.show(instant);
    else this.hide();
    this.labels.strip = this.unrolled.taken;
  }

  private hide(): void {
    this.group.visible = false;
    this.unrolled.element.hidden = true;
    this.labels.set(this.label, "", 0, 0);
  }

  private show({ placed, pose, progress, reach, rim, simulated }: Instant): void {
    const { radius } = rim;
    this.group.visible = true;
    this.unrolled.show(progress, radius);
    const lowest = progress && lowestOf(simulated?.motion, progress.start, progress.turn);
    const times = magnification(lowest?.tilt, radius);
    const gap = gapOf(pose, radius);
    const fade = fadeOf(times * gap, radius);
    this.magnified.visible = fade > 0;
    this.rim.material.opacity = this.posts.material.opacity = fade;
    this.base.material.opacity = 0.16 * fade;
    const size = radius / reach;
    for (let k = 0; k < MARKS; k++) {
      const angle = MARK_PLACE + k * SPACING;
      const { x, y, z } = this.spot
        .set(radius * Math.cos(angle), radius * Math.sin(angle), 0)
        .applyMatrix4(placed);
      const large = k === 0 ? 1.5 : 1;
      this.matrix.makeScale(large * MARK * size, large * MARK * size, large * MARK * size);
      this.marks.setMatrixAt(k, this.matrix.setPosition(x, y, z));
      this.matrix.makeScale(large * POST * size, large * POST * size, Math.max(times * z, 1e-4));
      this.posts.setMatrixAt(k, this.matrix.setPosition(x, y, 0));
    }
    this.marks.instanceMatrix.needsUpdate = this.posts.instanceMatrix.needsUpdate = true;
    this.stretch(placed, times, radius);
    const { x, y, z } = this.spot
      .set(Math.cos(pose.yaw), Math.sin(pose.yaw), 0)
      .multiplyScalar(size * Math.cos(pose.tilt));
    // Where the gap is too wide to be magnified, it has no label.
    this.labels.set(
      this.label,
      fade > 0.5 ? labelOf(gap, times) : "",
      pose.x / reach + x,
      pose.y / reach + y,
      z + (times * gap) / reach + 0.14 * size,
    );
  }

  /** Stretches the heights of the rim and the base over the table. */
  private stretch(placed: Matrix4, times: number, radius: number): void {
    const { matrix } = this.rim;
    matrix.makeScale(1, 1, times).multiply(placed);
    // The rim is not thicker for that.
    const { elements } = matrix;
    const thick = Math.hypot(placed.elements[0]!, placed.elements[1]!, placed.elements[2]!);
    [elements[8], elements[9], elements[10]] = [0, 0, thick];
    matrix.scale(this.spot.setScalar(radius));
    this.base.matrix.copy(matrix);
    this.rim.matrixWorldNeedsUpdate = this.base.matrixWorldNeedsUpdate = true;
  }
}

const labelOf = (gap: number, times: number) =>
  times > 1
    ? say(words.scene.gapDrawn, { gap: formatSmall(gap), times: formatNumber(times) })
    : say(words.scene.gap, { gap: formatSmall(gap) });

const flat = (opacity: number) =>
  new MeshBasicMaterial({
    toneMapped: false,
    transparent: true,
    opacity,
    depthWrite: false,
    side: DoubleSide,
  });

// The rim and the table, unrolled: how far the contact point has run along each since the turn began. The
// two lengths differ by what the rim has slipped along itself.

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

// The gap between rim and table, and how much it is magnified in the picture. Lengths are in m.

/** The smallest gap of a turn is drawn about as high as this, in radii of the rim. */
const HEIGHT = 0.5;
/** A gap that would be drawn higher fades, and is not drawn from twice this height on. */
const HIGHEST = 1.2;

/** Height of the highest point of the rim over the table. */
export const gapOf = ({ tilt, z }: Pick<Pose, "tilt" | "z">, radius: number): number =>
  z + radius * Math.sin(tilt);

/** The magnification, 1, 2 or 5 times a power of ten, for a turn with a smallest tilt (rad). */
export function magnification(minTilt: number | undefined, radius: number): number {
  const smallest = 2 * radius * Math.sin(minTilt ?? NaN);
  if (!(smallest > 0)) return 1;
  const times = (HEIGHT * radius) / smallest;
  const ten = 10 ** Math.floor(Math.log10(times));
  const round = [5, 2, 1].find((one) => one * ten <= times) ?? 1;
  return Math.max(round * ten, 1);
}

/** Opacity of a gap that is drawn with a height. */
export const fadeOf = (height: number, radius: number): number =>
  Math.min(Math.max(2 - height / (HIGHEST * radius), 0), 1);
