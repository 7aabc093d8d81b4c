// Starts the page: loads the core, creates the lab and mounts each section on it.

import { followAnchors } from "./anchors";
import { mountControls } from "./controls/controls";
import { Core } from "./core/core";
import { element } from "./elements";
import { embed } from "./embed";
import { shakeOnDemand } from "./floor/loading";
import { mountFlicks } from "./flicks/flicks";
import { Lab } from "./lab";
import { mountLimits } from "./limits/section";
import { mountScene } from "./scene/scene";
import { EMBED, keepInAddress } from "./setup/address";
import { mountShare } from "./share/share";
import { mountStory } from "./story/story";
import "./style/page.css";
import { startTicker } from "./ticker";
import { mountTransport } from "./transport/transport";
import { mountVerdict } from "./verdict/verdict";

const section = (id: string) => document.getElementById(id) as HTMLElement;

// The plots are below the first view, so that the other parts need not wait for them.
const loadingPlots = import("./plots/plots");

async function start(): Promise<void> {
  const core = await Core.load(await coreOfPage());
  const lab = new Lab(core);
  keepInAddress(lab);
  shakeOnDemand(lab);
  startTicker(lab.clock);
  mountScene(lab, section("scene"));
  mountTransport(lab, section("transport"));
  mountVerdict(lab, section("verdict"));
  mountStory(lab, section("story"));
  mountControls(lab, section("controls"));
  mountFlicks(lab, section("flicks"));
  loadingPlots.then(({ mountPlots }) => mountPlots(lab, section("plots"))).catch(console.error);
  if (EMBED) embed(lab, section("transport"));
  mountShare(lab, section("share"));
  mountLimits(lab, section("limits"));
}

/** The page that rimroll.lab makes carries the core, since it may load nothing. */
const coreOfPage = (): ArrayBuffer | Promise<Response> =>
  import.meta.env.MODE === "alone"
    ? (globalThis as unknown as { rimrollCore: ArrayBuffer }).rimrollCore
    : fetch(new URL("./core/rimroll.wasm", import.meta.url));

followAnchors();
start().catch((error: unknown) => {
  console.error(error);
  section("lab").replaceChildren(
    element("p", { class: "no-page", role: "alert" }, `This page could not start: ${why(error)}`),
  );
});

const why = (error: unknown) =>
  `${error instanceof Error ? error.message : String(error)}. Reloading it may help.`;
