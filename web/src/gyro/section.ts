// The section on a gyroscope in the body: its star, and a record as a phone would save it.

import { computed, effect } from "@preact/signals-core";
import { button, element, svgElement } from "../elements";
import { formatDegrees, formatNumber } from "../format";
import type { Lab } from "../lab";
import { INITIAL, type Setup } from "../setup/setup";
import { download } from "../setup/export";
import "./gyro.css";
import { bodyRates, bodyRatesIn, toPhyphox } from "./rates";
import { say, sentences, words } from "../words/words";
import { countBelow, type Moments, type Motion } from "../core/motion";

export function mountGyro(lab: Lab, place: HTMLElement): void {
  const view = `${-SIZE} ${-SIZE} ${2 * SIZE} ${2 * SIZE}`;
  const picture = svgElement("svg", { viewBox: view, role: "img" });
  const circle = svgElement("circle", { class: "circle" });
  const cross = svgElement("path", {
    class: "circle",
    d: `M${-SIZE} 0H${SIZE}M0 ${-SIZE}V${SIZE}`,
  });
  const whole = svgElement("path", { class: "whole" });
  const past = svgElement("path", { class: "past" });
  const now = svgElement("circle", { class: "now", r: 4 });
  const scale = svgElement("text", { x: 3, "text-anchor": "start" });
  picture.append(circle, cross, whole, past, now, scale);
  const said = element("p", { class: "said" });
  const message = element("p", { class: "done", role: "status" });
  const save = button(words.gyro.save, () =>
    lab.whenComplete(() => {
      const motion = lab.motion.value;
      if (!motion) return;
      const name = `rimroll-${lab.setup.value.body}-phyphox.csv`;
      download(name, toPhyphox(motion), "text/csv");
      message.textContent = say(words.gyro.saved, {
        name,
        command: `rimroll gyro ${name} ${optionsOf(lab.setup.value)}`,
      });
    }),
  );
  place.append(
    element("h2", {}, words.gyro.title),
    element("p", {}, words.gyro.intro),
    element("figure", {}, picture as unknown as HTMLElement, said),
    element("div", { class: "buttons" }, save),
    message,
  );
  const star = computed(() => lab.motion.value && new Star(lab.motion.value));
  effect(() => {
    const motion = lab.motion.value;
    save.disabled = !motion;
    if (!motion || !star.value) return;
    const { largest } = star.value;
    whole.setAttribute("d", star.value.path());
    const [radius] = star.value.place(largest, 0);
    circle.setAttribute("r", String(radius));
    scale.setAttribute("y", String(-radius + 9));
    scale.textContent = `${formatNumber(largest, 3)} rad/s`;
    const veers = motion.turns
      .slice(0, 4)
      .map(({ angle }) => formatDegrees(Math.abs(angle) - Math.PI, 1));
    said.textContent =
      veers.length > 0 ? say(words.gyro.veers, { angles: veers.join("; ") }) : words.gyro.noTurn;
    picture.setAttribute(
      "aria-label",
      sentences(
        say(words.gyro.picture, { largest: `${formatNumber(largest, 3)} rad/s` }),
        said.textContent,
      ),
    );
  });
  effect(() => {
    const motion = lab.motion.value;
    if (!motion || !star.value) return;
    const time = lab.clock.time.value;
    past.setAttribute("d", star.value.path(time));
    const { x, y } = bodyRates(motion.at([time]));
    const [cx, cy] = star.value.place(x[0]!, y[0]!);
    now.setAttribute("cx", cx.toFixed(1));
    now.setAttribute("cy", cy.toFixed(1));
  });
}

/** The body as the command takes it, a preset or a file that describes it, and gravity unless it is that of the command. */
const optionsOf = ({ body, fill, gravity }: Readonly<Setup>) => {
  const name = body === "own" || body === "inertia" || fill > 0 ? "my_body.toml" : body;
  return `--body ${name}` + (gravity === INITIAL.gravity ? "" : ` --gravity ${gravity}`);
};

// The star: the path of the rate across the axis, in the body's frame. A fall is a ray to the middle and out again;
// each near-collision turns the ray by the angle of turn less a half turn.

/** Half the size of the picture. */
export const SIZE = 100;
/** Radius of the longest ray in the picture. */
const LONGEST = 84;
/** No more points than this are drawn. */
const MOST_POINTS = 3000;

/** The star of a motion. */
export class Star {
  /** The rate that the outer circle stands for, rad/s. */
  readonly largest: number;
  private readonly times: number[] = [];
  private readonly points: string[] = [];

  constructor(motion: Motion) {
    const moments = motion.curve();
    this.largest = roundUp(largestOf(moments));
    const every = Math.max(1, Math.ceil(moments.length / MOST_POINTS));
    const [times, rates] = [moments.column("t"), bodyRatesIn(moments)];
    for (let k = 0; k < moments.length; k += every) {
      const { x, y } = rates(k);
      this.times.push(times[k]!);
      this.points.push(
        this.place(x, y)
          .map((at) => at.toFixed(1))
          .join(" "),
      );
    }
  }

  /** A place in the picture for rates along x and y, rad/s. */
  place(x: number, y: number): [x: number, y: number] {
    return [(LONGEST * x) / this.largest, (-LONGEST * y) / this.largest];
  }

  /** The path up to a time (s) about the middle of an SVG. */
  path(until = Infinity): string {
    const points = this.points.slice(0, countBelow(this.times, until));
    return points.length > 0 ? `M${points.join("L")}` : "";
  }
}

/** The largest rate across the axis, rad/s. */
function largestOf(moments: Moments): number {
  const [tilt, tiltRate] = [moments.column("tilt"), moments.column("tilt_rate")];
  const yawRate = moments.column("yaw_rate");
  let largest = 0;
  for (let k = 0; k < moments.length; k++)
    largest = Math.max(largest, Math.hypot(yawRate[k]! * Math.sin(tilt[k]!), tiltRate[k]!));
  return largest;
}

/** The next larger round number. */
function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return (
    [1, 1.5, 2, 3, 4, 6, 8, 10].map((times) => times * power).find((one) => one >= value) ?? value
  );
}
