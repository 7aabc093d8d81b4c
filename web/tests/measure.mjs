// Measures the speed of the built page in a headless Chromium: the size and time of loading, the cost of
// a frame while a motion plays, and the cost of a move of a slider. It is no test, because times depend
// on the machine. Without a graphics card the scene is drawn in software, which delays the first picture
// and the frames. Playing and sliding are therefore measured on the page's main thread without the scene,
// so that moves of the slider are not taken for the last one. With the argument "scene", playing is
// measured with the scene. Run from the root: tools/node.sh node tests/measure.mjs

import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";

const PAGE = fileURLToPath(new URL("../../python/rimroll/page", import.meta.url));
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };
const FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const LAPTOP = { width: 1366, height: 768 };
/** A slow line: Mbit/s, and round-trip time in ms. */
const LINE = { mbit: 10, latency: 40 };

let sent = 0;
const server = createServer(async (request, response) => {
  const path = new URL(request.url, "http://here").pathname;
  try {
    const content = gzipSync(await readFile(join(PAGE, path === "/" ? "index.html" : path)));
    sent += content.length;
    response.setHeader("Content-Type", TYPES[extname(path || ".html")] ?? "application/wasm");
    if (path === "/") response.setHeader("Content-Type", TYPES[".html"]);
    response.setHeader("Content-Encoding", "gzip");
    response.end(content);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
const address = `http://127.0.0.1:${server.address().port}/`;
const browser = await chromium.launch({
  executablePath: process.env.RIMROLL_CHROMIUM ?? "/usr/bin/chromium-headless-shell",
  args: FLAGS,
});

/** Records in the page when the first motion, or the essay's question, and its picture appear. */
function noteFirsts() {
  const firsts = {};
  window.firsts = firsts;
  const there = {
    motion: () => document.querySelector("#verdict .said, #essay .hands")?.textContent,
    picture: () => document.querySelector(":is(#scene, #essay) :is(canvas[data-engine], .blind)"),
  };
  const look = () => {
    for (const [name, is] of Object.entries(there))
      if (!(name in firsts) && is())
        // The picture is visible in the next frame.
        requestAnimationFrame(() => (firsts[name] ??= performance.now()));
    if (Object.keys(firsts).length < 2) requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

function withoutWebGL() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (...asked) {
    return String(asked[0]).startsWith("webgl") ? null : getContext.apply(this, asked);
  };
}

/** Visits the page with a slowed-down processor, on a line or without delay. */
async function visited({ hash = "lab", slower = 1, line = undefined, webgl = true }, what) {
  const context = await browser.newContext({ viewport: LAPTOP });
  await context.addInitScript(noteFirsts);
  if (!webgl) await context.addInitScript(withoutWebGL);
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  const devtools = await context.newCDPSession(page);
  await devtools.send("Emulation.setCPUThrottlingRate", { rate: slower });
  await devtools.send("Network.enable");
  if (line) {
    const bytes = (line.mbit * 1e6) / 8;
    await devtools.send("Network.emulateNetworkConditions", {
      ...{ offline: false, latency: line.latency },
      ...{ downloadThroughput: bytes, uploadThroughput: bytes },
    });
  }
  sent = 0;
  await page.goto(address + (hash && `#${hash}`));
  await page.waitForFunction(() => Object.keys(window.firsts).length === 2);
  const result = await what(page, devtools);
  await context.close();
  return result;
}

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

async function loading(slower, line, hash = "") {
  const runs = [];
  for (let k = 0; k < 3; k++)
    runs.push(
      await visited({ slower, line, hash }, (page) =>
        page.evaluate(() => ({
          words: performance.getEntriesByName("first-contentful-paint")[0]?.startTime,
          ...window.firsts,
        })),
      ),
    );
  const ms = (name) => `${name} ${Math.round(median(runs.map((run) => run[name])))} ms`;
  const how = line ? `${line.mbit} Mbit/s, ${line.latency} ms` : "no delay";
  console.log(
    `loading  ${hash || "essay"}, ${how}, processor 1/${slower}: ${["words", "motion", "picture"].map(ms).join(", ")}`,
  );
}

/** Seconds that the page's main thread has spent on each task. */
async function spent(devtools) {
  const { metrics } = await devtools.send("Performance.getMetrics");
  return Object.fromEntries(metrics.map(({ name, value }) => [name, value]));
}

/** Cost of an action on the page's main thread, ms per repetition. */
async function cost(devtools, act) {
  await devtools.send("Performance.enable");
  const before = await spent(devtools);
  const times = await act();
  const after = await spent(devtools);
  const each = (name) => (1e3 * (after[name] - before[name])) / times;
  const layout = each("LayoutDuration") + each("RecalcStyleDuration");
  const [script, all] = [each("ScriptDuration"), each("TaskDuration")];
  return { times, script, layout, all };
}

const report = ({ script, layout, all }) =>
  `scripts ${script.toFixed(1)} ms, layout ${layout.toFixed(1)} ms, in all on the main thread ${all.toFixed(1)} ms`;

async function playing(name, hash) {
  const webgl = process.argv.includes("scene");
  const result = await visited({ hash, webgl }, async (page, devtools) => {
    // Wait until delayed work is done.
    await page.waitForTimeout(2500);
    await page.getByRole("button", { name: "Let go" }).click();
    await page.waitForTimeout(500);
    return cost(devtools, () =>
      page.evaluate(async () => {
        const end = performance.now() + 3000;
        let frames = 0;
        while (performance.now() < end) {
          await new Promise(requestAnimationFrame);
          frames++;
        }
        return frames;
      }),
    );
  });
  console.log(`playing  ${name}, ${result.times} frames: each ${report(result)}`);
}

async function sliding(name, hash) {
  const result = await visited({ hash, webgl: false }, async (page, devtools) => {
    await page.waitForTimeout(2500);
    return cost(devtools, () =>
      page.evaluate(async () => {
        const slider = document.getElementById("tilt-slider");
        const moves = 20;
        for (let k = 0; k < moves; k++) {
          slider.value = String(20 + (k % 10) * 0.5);
          slider.dispatchEvent(new Event("input", { bubbles: true }));
          // The motion is computed in one frame and drawn in the next.
          await new Promise(requestAnimationFrame);
          await new Promise(requestAnimationFrame);
        }
        return moves;
      }),
    );
  });
  console.log(`sliding  ${name}: each move ${report(result)}`);
}

/** The longest task on the page's thread after a change of the set-up, without the scene: its processor time, which other
 * programs on the machine do not change, and its duration. */
async function longest(name, hash) {
  const tasks = await visited({ webgl: false }, async (page) => {
    await page.waitForTimeout(2500);
    await browser.startTracing(page, { categories: ["toplevel"] });
    await page.evaluate(async (hash) => {
      location.hash = hash;
      await new Promise((passed) => setTimeout(passed, 5000));
    }, hash);
    const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
    const thread = ({ pid, tid }) => `${pid} ${tid}`;
    const main = traceEvents.filter(
      (event) => event.name === "thread_name" && event.args.name === "CrRendererMain",
    );
    const threads = new Set(main.map(thread));
    return traceEvents.filter((event) => threads.has(thread(event)) && event.tdur > 0);
  });
  // Times are in µs.
  const { tdur, dur } = tasks.reduce((a, b) => (b.tdur > a.tdur ? b : a));
  const ms = (time) => `${Math.round(time / 1000)} ms`;
  console.log(`longest  ${name}: ${ms(tdur)} on the processor, ${ms(dur)} in all`);
}

for (const part of ["", "lab"]) {
  await visited({ hash: part }, async () => {});
  console.log(`loading  ${part || "essay"}: ${Math.round(sent / 1000)} kB in all, gzipped`);
  await loading(1, undefined, part);
  await loading(1, LINE, part);
  await loading(4, LINE, part);
}
for (const [name, hash] of [
  ["the paper's can", "lab"],
  ["the can, friction 0.3", "friction=0.3"],
  ["a coin", "body=coin"],
]) {
  await playing(name, hash);
  await sliding(name, hash);
}
await sliding("a body of your own", "body=own");
await longest("a coin for 3 s", "body=coin");
await longest("Euler's disk for 120 s", "body=euler_disk&duration=120");
await browser.close();
server.close();
