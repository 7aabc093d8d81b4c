// The page in a frame of another page, or on a slide: the scene, its playback and the button to let go.

import { effect } from "@preact/signals-core";
import { element } from "./elements";
import type { Lab } from "./lab";
import { LAB } from "./part";
import { hashOf } from "./setup/address";
import "./style/embed.css";
import { words } from "./words/words";

/** Leaves only what fits into a small frame, with a link to all of it. */
export function embed(lab: Lab, transport: HTMLElement): void {
  document.documentElement.classList.add("embed");
  const link = element("a", { class: "whole", target: "_blank", rel: "noopener" }, words.openLab);
  transport.querySelector(".row")?.append(link);
  effect(() => {
    link.href = `${location.pathname}${location.search}#${hashOf(lab) || LAB}`;
  });
}
