// Starts the page: loads the core, and shows the essay or the lab, as the address says.

import { followAnchors, type Part, partOf, shownPart, showPart } from "./part";
import { Core } from "./core/core";
import { element } from "./elements";
import { Essay } from "./essay/essay";
import type { Lab } from "./lab";
// The styles of the lab's parts come before those of the page, which are stronger, for example on paper.
import "./compare/compare.css";
import "./style/embed.css";
import "./falls/flicks.css";
import "./gyro/gyro.css";
import "./limits/limits.css";
import "./story/story.css";
import "./style/page.css";
import { mountLanguages, translatePage } from "./words/page";
import { say, words } from "./words/words";

// Lets a published page open without a network after the first visit.

/** The file that vite.config.ts builds from service_worker.ts. */
const SCRIPT = "./offline.js";

/** A server on this machine may serve another page at the same address tomorrow. */
const isLocal = (host: string) => host === "localhost" || /^127\.|^\[::1\]$/.test(host);

/** Registers the service worker of a published page, once the page has loaded. Visitors who save data are spared the
 * parts that they may never use. */
function keepForOffline(): void {
  const { connection, serviceWorker } = navigator as Navigator & {
    connection?: { saveData?: boolean };
  };
  // Undefined where the page has no secure address.
  if (!serviceWorker || isLocal(location.hostname) || connection?.saveData) return;
  const register = () => void serviceWorker.register(SCRIPT).catch(console.error);
  if (document.readyState === "complete") register();
  else addEventListener("load", register, { once: true });
}

const section = (id: string) => document.getElementById(id) as HTMLElement;

const loadLab = () => import("./lab_page");
// The lab is loaded together with the core if the address shows it.
const loadingLab = partOf(location.hash) === "lab" ? loadLab() : undefined;

async function start(): Promise<void> {
  const core = await Core.load(await coreOfPage());
  let essay: Essay | undefined;
  let lab: Promise<Lab> | undefined;
  const route = (part: Part, hash: string) => {
    const other = part !== shownPart();
    showPart(part);
    if (part === "lab") {
      essay?.close();
      lab ??= (loadingLab ?? loadLab()).then(({ startLab }) => startLab(core));
      lab.catch(notStarted);
    } else {
      lab?.then(({ clock }) => clock.pause()).catch(console.error);
      essay ??= new Essay(core, section("essay"));
      essay.open(hash);
    }
    if (other && !hash.slice(1)) scrollTo({ top: 0, behavior: "instant" });
    if (other && part === "lab") scrollTo({ top: 0, behavior: "instant" });
  };
  addEventListener("hashchange", () => route(partOf(location.hash), location.hash));
  route(partOf(location.hash), location.hash);
}

/** The page that rimroll.lab makes carries the core, since it may load nothing. */
const coreOfPage = (): ArrayBuffer | Promise<Response> =>
  import.meta.env.MODE === "alone"
    ? (globalThis as unknown as { rimrollCore: ArrayBuffer }).rimrollCore
    : fetch(new URL("./core/rimroll.wasm", import.meta.url));

if (import.meta.env.MODE !== "alone") keepForOffline();
translatePage();
mountLanguages(section("languages"));
showPart(partOf(location.hash));
followAnchors();
start().catch(notStarted);

function notStarted(error: unknown): void {
  console.error(error);
  section(shownPart()).replaceChildren(
    element("p", { class: "no-page", role: "alert" }, say(words.notStarted, { why: why(error) })),
  );
}

function why(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
