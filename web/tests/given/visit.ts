// Visits to the page in a headless Chromium.

import { type Browser, type BrowserContextOptions, type Page, chromium } from "playwright-core";
import { afterAll, afterEach, beforeAll } from "vitest";
import { type Served, serve } from "./server";

// Test machines have no graphics card, so WebGL is drawn in software.
const FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

/** A host name that only this browser resolves to the page. */
export const PUBLIC_HOST = "rimroll.example";

export interface VisitOptions extends BrowserContextOptions {
  /** The part of the address after #; by default that of the lab. */
  hash?: string;
  /** Whether the browser has WebGL, which is slow without a graphics card. */
  webgl?: boolean;
  /** Host name of the page, if not the address of this machine. */
  host?: string;
  /** The part of the address after ?. */
  query?: string;
  /** What the button says that lets the body go, in the language of the page. */
  letGo?: string;
}

/** An open page and its errors. */
export interface Visit {
  page: Page;
  /** Addresses of all requests. */
  requests: string[];
  /** Errors and warnings of scripts, the console and requests. */
  complaints: string[];
}

let browser: Browser;
let served: Served;

/** Opens a browser for the tests of a file and closes it after them. After each test its pages are
 * closed, because an open page keeps drawing. */
export function browserForAll(): void {
  beforeAll(async () => {
    served = await serve();
    const executablePath = process.env["RIMROLL_CHROMIUM"] ?? "/usr/bin/chromium-headless-shell";
    const args = [...FLAGS, `--host-resolver-rules=MAP ${PUBLIC_HOST} 127.0.0.1`];
    browser = await chromium.launch({ executablePath, args });
  });
  afterEach(async () => {
    await Promise.all(browser.contexts().map((context) => context.close()));
  });
  afterAll(async () => {
    await browser?.close();
    await served?.close();
  });
}

/** Requests that leave the folder of the page. */
export const elsewhere = (requests: readonly string[]): string[] =>
  requests.filter((one) => !one.startsWith(served.address) && !/^(data|blob):/.test(one));

export const addressOfPage = (): string => served.address;

/** An empty page of the browser. */
export async function emptyPage(options: BrowserContextOptions = {}): Promise<Page> {
  const context = await browser.newContext(options);
  await context.addInitScript(withoutWebGL);
  context.setDefaultTimeout(150_000);
  return context.newPage();
}

/** Opens the page in a fresh context and waits until it has started. */
export async function visit(options: VisitOptions = {}): Promise<Visit> {
  const { hash = "lab", webgl = false, host, query = "", letGo = "Let go", ...rest } = options;
  const context = await browser.newContext({
    viewport: { width: 1366, height: 768 },
    acceptDownloads: true,
    permissions: ["clipboard-read", "clipboard-write"],
    ...rest,
  });
  if (!webgl) await context.addInitScript(withoutWebGL);
  context.setDefaultTimeout(150_000);
  const page = await context.newPage();
  const requests: string[] = [];
  const complaints: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  page.on("requestfailed", (request) => complaints.push(`not loaded: ${request.url()}`));
  page.on("pageerror", (error) => complaints.push(String(error)));
  // Chromium warns about drawing in software, and three.js about missing WebGL.
  page.on("console", (message) => {
    const text = message.text();
    const expected =
      /GPU stall|GL Driver Message|software WebGL/i.test(text) || (!webgl && /WebGL/.test(text));
    if (["error", "warning"].includes(message.type()) && !expected) complaints.push(text);
  });
  const address = host ? served.address.replace("127.0.0.1", host) : served.address;
  await page.goto(`${address}${query && `?${query}`}#${hash}`);
  const part = await page.evaluate(() => document.documentElement.dataset["part"]);
  const place = page.locator(`#${part}`);
  await place.getByRole("button", { name: letGo }).first().waitFor();
  // three.js marks the canvas that it draws on. The notice names WebGL in each language.
  const notice = place.getByText(/WebGL|cannot show the picture/);
  await (webgl ? place.locator("canvas[data-engine]") : notice.first()).waitFor();
  return { page, requests, complaints };
}

/** Scrolls to a scene of the essay until it is alive. */
export async function goTo(page: Page, id: string): Promise<void> {
  // A visitor who does something leaves the section that the address names.
  await page.keyboard.press("Shift");
  await page
    .locator(`#${id}`)
    .locator(".place")
    .evaluate((place) => place.scrollIntoView({ block: "center", behavior: "instant" }));
  await page.locator(`#${id}`).locator(".table-stage").waitFor({ state: "attached" });
}

function withoutWebGL(): void {
  const getContext = HTMLCanvasElement.prototype.getContext as (...a: unknown[]) => unknown;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...asked: unknown[]) {
    return String(asked[0]).startsWith("webgl") ? null : getContext.apply(this, asked);
  } as typeof HTMLCanvasElement.prototype.getContext;
}
