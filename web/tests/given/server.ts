// A web server that serves the files of the page from a nested folder.

import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join } from "node:path";
import { fileURLToPath } from "node:url";

/** The folder of the built page. */
export const PAGE = fileURLToPath(new URL("../../../python/rimroll/page", import.meta.url));

const FOLDER = "/~teacher/physics/the can/";

const TYPES: Record<string, string> = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
};

export interface Served {
  /** Address of the page. */
  address: string;
  close(): Promise<void>;
}

export async function serve(): Promise<Served> {
  const server = createServer(async (request, response) => {
    const path = decodeURI(new URL(request.url ?? "", "http://here").pathname);
    const name = path === FOLDER ? "index.html" : path.slice(FOLDER.length);
    try {
      if (!path.startsWith(FOLDER) || name.includes(".."))
        throw new Error("not a file of the page");
      const content = await readFile(join(PAGE, name));
      response.setHeader("Content-Type", TYPES[extname(name)] ?? "application/octet-stream");
      response.end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise<void>((listening) => server.listen(0, "127.0.0.1", listening));
  const { port } = server.address() as AddressInfo;
  return {
    address: `http://127.0.0.1:${port}${encodeURI(FOLDER)}`,
    close: () =>
      new Promise((closed) => {
        server.closeAllConnections();
        server.close(() => closed());
      }),
  };
}
