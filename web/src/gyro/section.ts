// The section on a gyroscope in the body: its star, and a record as a phone would save it.

import { computed, effect } from "@preact/signals-core";
import { button, element, svgElement } from "../elements";
import { formatDegrees, formatNumber } from "../format/numbers";
import type { Lab } from "../lab";
import { INITIAL, type Setup } from "../setup/setup";
import { download } from "../share/download";
import "./gyro.css";
import { toPhyphox } from "./phyphox";
import { bodyRates } from "./rates";
import { SIZE, Star } from "./star";
import { say, sentences, words } from "../words/words";

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
