// The lab: its parts, mounted into the sections of the page. It is loaded when the address first shows it.

import { mountCompare } from "./compare/section";
import { mountControls } from "./controls/controls";
import type { Core } from "./core/core";
import { embed } from "./embed";
import { shakeOnDemand } from "./floor/loading";
import { mountFlicks } from "./flicks/flicks";
import { mountGyro } from "./gyro/section";
import { Lab } from "./lab";
import { mountLimits } from "./limits/section";
import { mountScene } from "./scene/scene";
import { EMBED, keepInAddress } from "./setup/address";
import { mountShare } from "./share/share";
import { mountStory } from "./story/story";
import { startTicker } from "./ticker";
import { mountTransport } from "./transport/transport";
import { mountVerdict } from "./verdict/verdict";

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
