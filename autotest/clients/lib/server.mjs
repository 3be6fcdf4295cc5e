// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
import { createServer } from "node:http";
import { readFile, stat } from "node:fs/promises";
import path from "node:path";

const TYPES = {
  ".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript", ".css": "text/css",
  ".json": "application/json", ".wasm": "application/wasm", ".png": "image/png", ".jpg": "image/jpeg",
  ".terrain": "application/vnd.quantized-mesh",
};

async function readUnder(folder, name) {
  const file = path.join(folder, name);
  const relative = path.relative(folder, file);
  if (relative.startsWith("..") || path.isAbsolute(relative)) return undefined;
  try {
    const isFolder = (await stat(file)).isDirectory();
    return { name: file, bytes: await readFile(isFolder ? path.join(file, "index.html") : file) };
  } catch {
    return undefined;
  }
}

/**
 * Serves folders on a free port of this machine: `mounts` maps the first part of a path to a folder,
 * "" is for everything else. `encoding`: announce gzip tiles with Content-Encoding, as a well-kept server
 * does; without it the server behaves as `python3 -m http.server`. `failures` collects the paths answered with 404.
 */
export async function serve(mounts, { encoding = true } = {}) {
  const failures = [];
  const server = createServer(async (request, response) => {
    const name = decodeURIComponent(new URL(request.url, "http://localhost").pathname).slice(1);
    const [first, ...rest] = name.split("/");
    const found = first && first in mounts ? await readUnder(mounts[first], rest.join("/"))
                                           : await readUnder(mounts[""], name);
    response.setHeader("Access-Control-Allow-Origin", "*");
    if (!found) {
      failures.push("/" + name);
      response.writeHead(404).end("not found");
      return;
    }
    const extension = path.extname(found.name) || ".html";
    response.setHeader("Content-Type", TYPES[extension] ?? "application/octet-stream");
    const packed = found.bytes[0] === 0x1f && found.bytes[1] === 0x8b;
    if (encoding && extension === ".terrain" && packed) response.setHeader("Content-Encoding", "gzip");
    response.end(found.bytes);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {
    failures,
    url: `http://127.0.0.1:${server.address().port}/`,
    close: () => { server.closeAllConnections?.(); server.close(); },
  };
}
