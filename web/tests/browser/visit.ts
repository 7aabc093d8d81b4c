// Visits to the page in a headless Chromium.

import { type Browser, type BrowserContextOptions, type Page, chromium } from "playwright-core";
import { afterAll, beforeAll } from "vitest";
import { type Served, serve } from "../given/server";

// Without a graphics card, as on a machine for tests, WebGL is drawn in software.
const FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

export interface VisitOptions extends BrowserContextOptions {
  /** What the address holds after #. */
  hash?: string;
  /** Whether the browser can draw in space; without it pages come much sooner. */
  webgl?: boolean;
}

/** A page that is open, and all that has gone wrong in it. */
export interface Visit {
  page: Page;
  /** Whatever the page asked for, from anywhere. */
  requests: string[];
  /** Errors and warnings: of scripts, on the console, of requests. */
  complaints: string[];
}

let browser: Browser;
let served: Served;

/** Opens a browser for the tests of a file, and closes it after them. */
export function browserForAll(): void {
  beforeAll(async () => {
    served = await serve();
    const executablePath = process.env["RIMROLL_CHROMIUM"] ?? "/usr/bin/chromium-headless-shell";
    browser = await chromium.launch({ executablePath, args: FLAGS });
  });
  afterAll(async () => {
    await browser?.close();
    await served?.close();
  });
}

/** The address of the page. */
export const address = () => served.address;

/** Opens the page as a visitor whom nobody knows, and waits until there is something to see. */
export async function visit(options: VisitOptions = {}): Promise<Visit> {
  const { hash = "", webgl = false, ...rest } = options;
  const context = await browser.newContext({
    viewport: { width: 1366, height: 768 },
    acceptDownloads: true,
    permissions: ["clipboard-read", "clipboard-write"],
    ...rest,
  });
  if (!webgl) await context.addInitScript(withoutWebGL);
  context.setDefaultTimeout(20_000);
  const page = await context.newPage();
  const requests: string[] = [];
  const complaints: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  page.on("requestfailed", (request) => complaints.push(`not loaded: ${request.url()}`));
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !ofTheDriver(message.text()))
      complaints.push(message.text());
  });
  await page.goto(served.address + (hash && `#${hash}`));
  await page.getByRole("button", { name: "Let go" }).waitFor();
  return { page, requests, complaints };
}

/** Closes a visit, so that it draws no longer. */
export const leave = ({ page }: Visit): Promise<void> => page.context().close();

/** Chromium's own remarks on drawing in software. */
const ofTheDriver = (text: string) => /GPU stall|GL Driver Message|software WebGL/i.test(text);

function withoutWebGL(): void {
  const getContext = HTMLCanvasElement.prototype.getContext as (...a: unknown[]) => unknown;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...asked: unknown[]) {
    return String(asked[0]).startsWith("webgl") ? null : getContext.apply(this, asked);
  } as typeof HTMLCanvasElement.prototype.getContext;
}
