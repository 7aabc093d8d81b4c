// Starts the page: loads the core, and shows the essay or the lab, as the address says.

import { followAnchors } from "./anchors";
import { mountCompare } from "./compare/section";
import { mountControls } from "./controls/controls";
import { Core } from "./core/core";
import { element } from "./elements";
import { embed } from "./embed";
import { Essay } from "./essay/essay";
import { shakeOnDemand } from "./floor/loading";
import { mountFlicks } from "./flicks/flicks";
import { mountGyro } from "./gyro/section";
import { Lab } from "./lab";
import { mountLimits } from "./limits/section";
import { type Part, partOf, showPart, shownPart } from "./part";
import { keepForOffline } from "./offline/register";
import { mountScene } from "./scene/scene";
import { EMBED, keepInAddress } from "./setup/address";
import { mountShare } from "./share/share";
import { mountStory } from "./story/story";
import "./style/page.css";
import { startTicker } from "./ticker";
import { mountTransport } from "./transport/transport";
import { mountVerdict } from "./verdict/verdict";
import { words } from "./words/words";

const section = (id: string) => document.getElementById(id) as HTMLElement;

// The plots are below the first view, so that the other parts need not wait for them.
const loadingPlots = partOf(location.hash) === "lab" ? import("./plots/plots") : undefined;

async function start(): Promise<void> {
  const core = await Core.load(await coreOfPage());
  let essay: Essay | undefined;
  let lab: Lab | undefined;
  const route = (part: Part, hash: string) => {
    const other = part !== shownPart();
    showPart(part);
    if (part === "lab") {
      essay?.close();
      lab ??= startLab(core);
    } else {
      lab?.clock.pause();
      essay ??= new Essay(core, section("essay"));
      essay.open(hash);
    }
    if (other && !hash.slice(1)) scrollTo({ top: 0, behavior: "instant" });
    if (other && part === "lab") scrollTo({ top: 0, behavior: "instant" });
  };
  addEventListener("hashchange", () => route(partOf(location.hash), location.hash));
  route(partOf(location.hash), location.hash);
}

function startLab(core: Core): Lab {
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
  (loadingPlots ?? import("./plots/plots"))
    .then(({ mountPlots }) => mountPlots(lab, section("plots")))
    .catch(console.error);
  if (EMBED) embed(lab, section("transport"));
  mountShare(lab, section("share"));
  mountLimits(lab, section("limits"));
  mountGyro(lab, section("gyro"));
  return lab;
}

/** The page that rimroll.lab makes carries the core, since it may load nothing. */
const coreOfPage = (): ArrayBuffer | Promise<Response> =>
  import.meta.env.MODE === "alone"
    ? (globalThis as unknown as { rimrollCore: ArrayBuffer }).rimrollCore
    : fetch(new URL("./core/rimroll.wasm", import.meta.url));

if (import.meta.env.MODE !== "alone") keepForOffline();
showPart(partOf(location.hash));
followAnchors();
start().catch((error: unknown) => {
  console.error(error);
  section(shownPart()).replaceChildren(
    element("p", { class: "no-page", role: "alert" }, words.notStarted(why(error))),
  );
});

const why = (error: unknown) => (error instanceof Error ? error.message : String(error));
