// The lab: its parts, mounted into the sections of the page. It is loaded when the address first shows it.

import { mountCompare } from "./compare/section";
import { mountControls } from "./controls/controls";
import type { Core } from "./core/core";
import { shakeOnDemand } from "./floor/loading";
import { mountFlicks } from "./falls/section";
import { mountGyro } from "./gyro/section";
import { Lab } from "./lab";
import { mountLimits } from "./limits/section";
import { mountScene } from "./scene/scene";
import { EMBED, hashOf, keepInAddress } from "./setup/address";
import { mountShare } from "./share/share";
import { mountStory } from "./story/story";
import { startTicker } from "./timing";
import { mountTransport } from "./transport/transport";
import { mountVerdict } from "./verdict/verdict";
import { effect } from "@preact/signals-core";
import { element } from "./elements";
import { LAB } from "./part";
import "./style/embed.css";
import { words } from "./words/words";

const section = (id: string) => document.getElementById(id) as HTMLElement;

// The plots are below the first view, so that the other parts need not wait for them.
const loadingPlots = import("./plots/plots");

export function startLab(core: Core): Lab {
  const lab = new Lab(core);
  keepInAddress(lab);
  shakeOnDemand(lab);
  startTicker(lab.clock);
  mountScene(lab, section("scene"));
  mountTransport(lab, section("transport"));
  mountVerdict(lab, section("verdict"));
  mountStory(lab, section("story"));
  mountControls(lab, section("controls"));
  mountCompare(lab, section("compare"));
  mountFlicks(lab, section("flicks"));
  loadingPlots.then(({ mountPlots }) => mountPlots(lab, section("plots"))).catch(console.error);
  if (EMBED) embed(lab, section("transport"));
  mountShare(lab, section("share"));
  mountLimits(lab, section("limits"));
  mountGyro(lab, section("gyro"));
  return lab;
}

// The page in a frame of another page, or on a slide: the scene, its playback and the button to let go.

/** Leaves only what fits into a small frame, with a link to all of it. */
export function embed(lab: Lab, transport: HTMLElement): void {
  document.documentElement.classList.add("embed");
  const link = element("a", { class: "whole", target: "_blank", rel: "noopener" }, words.openLab);
  transport.querySelector(".row")?.append(link);
  effect(() => {
    link.href = `${location.pathname}${location.search}#${hashOf(lab) || LAB}`;
  });
}
