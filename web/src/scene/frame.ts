// The elements of the scene: the picture, its buttons, the key to its colours, and the notice that is
// shown if there is no picture.

import type { ViewName } from "../setup/playback";
import { words } from "../words/words";

/** Names of the places of the camera on their buttons. */
const PLACES = (["above", "contact", "below"] as const).map((name): [ViewName, string] => [
  name,
  words.scene.places[name],
]);

export interface Frame {
  stage: HTMLElement;
  canvas: HTMLCanvasElement;
  words: HTMLElement;
  /** The length of a square of the grid. */
  scale: HTMLElement;
  notice: HTMLElement;
  /** Says how a finger takes the body. */
  tip: HTMLElement;
  reset: HTMLButtonElement;
  /** Buttons that take the camera to a place. */
  places: ReadonlyMap<ViewName, HTMLButtonElement>;
}

function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  className: string,
  text = "",
): HTMLElementTagNameMap[Name] {
  const made = document.createElement(name);
  made.className = className;
  made.textContent = text;
  return made;
}

export function frameIn(place: HTMLElement): Frame {
  const stage = element("div", "table-stage");
  const canvas = element("canvas", "table-picture");
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application");
  canvas.setAttribute("aria-label", words.scene.picture);
  canvas.setAttribute("aria-describedby", "table-keys");
  const labels = element("div", "table-words");
  const notice = element("p", "table-notice");
  notice.setAttribute("role", "status");
  const tip = element("p", "table-tip", words.scene.tip);
  tip.hidden = true;
  const reset = button(words.scene.reset);
  const places = new Map(PLACES.map(([name, text]) => [name, button(text)]));
  const tools = element("div", "table-tools");
  tools.append(reset, ...places.values(), help());
  const [legend, scale] = key();
  stage.append(canvas, labels, legend, tools, tip, notice);
  place.replaceChildren(stage);
  return { stage, canvas, words: labels, scale, notice, tip, reset, places };
}

function button(text: string): HTMLButtonElement {
  const made = element("button", "table-button", text);
  made.type = "button";
  return made;
}

function help(): HTMLElement {
  const details = element("details", "table-help");
  const summary = element("summary", "table-button", "?");
  summary.setAttribute("aria-label", words.scene.help);
  const box = element("div", "table-help-box");
  box.id = "table-keys";
  // If the box is higher than the picture, keys can scroll it.
  box.tabIndex = 0;
  box.setAttribute("role", "group");
  box.setAttribute("aria-label", words.scene.help);
  box.append(element("p", "", words.scene.gestures), element("p", "", words.scene.keysTitle));
  const list = element("dl", "");
  for (const { key, does } of words.scene.keys)
    list.append(element("dt", "", key), element("dd", "", does));
  box.append(list);
  details.append(summary, box);
  return details;
}

/** The key to the colours of the trail, and the scale. */
function key(): [HTMLElement, HTMLElement] {
  const legend = element("p", "table-key");
  for (const [kind, means] of [
    ["rolling", words.scene.rolls],
    ["sliding", words.scene.slips],
    ["flying", words.scene.flies],
  ] as const)
    legend.append(element("span", `trail-${kind}`, means));
  const scale = element("span", "table-scale");
  legend.append(scale);
  return [legend, scale];
}
