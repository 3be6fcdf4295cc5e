// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
//   node preview_messages.mjs SET_DIR
//
// What the preview page says when it cannot show the terrain: opened from disk, CesiumJS out of reach, no
// layer.json, a set without level 0, a browser without WebGL. Each must name the cause and the cure.
import { realpathSync } from "node:fs";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { Findings } from "./lib/checks.mjs";
import { withPage } from "./lib/browser.mjs";
import { standInForCesiumSite } from "./lib/preview.mjs";
import { serve } from "./lib/server.mjs";

async function messageAt(page, url) {
  await page.goto(url);
  const failed = await page.evaluate(() => window.qmesh.ready.then(() => false, () => true));
  if (!failed) return "";
  return (await page.locator("#message").innerText()).replace(/\s+/g, " ");
}

const CASES = [
  { name: "opened from disk", file: true,
    says: (folder) => ["needs a web server", `python3 -m http.server 8000 --directory ${folder}`,
                       "http://localhost:8000/"] },
  { name: "CesiumJS out of reach", prepare: (page) => page.route(/Cesium\.js/, (route) => route.abort()),
    says: () => ["CesiumJS could not be loaded", "Cesium/", "online", "--cesium Build/Cesium"] },
  { name: "no layer.json",
    prepare: (page) => page.route(/layer\.json/, (route) => route.fulfill({ status: 404 })),
    says: () => ["no layer.json", "gdal2qmesh"] },
  { name: "no level 0",
    prepare: async (page, folder) => {
      const layer = JSON.parse(await readFile(path.join(folder, "layer.json"), "utf8"));
      layer.available[0] = [];
      await page.route(/layer\.json/, (route) => route.fulfill({ json: layer }));
    },
    says: () => ["no level 0", "gdal2qmesh -z 0-"] },
  { name: "no WebGL",
    prepare: (page) => page.addInitScript(() => { HTMLCanvasElement.prototype.getContext = () => null; }),
    says: () => ["cannot draw in 3D", "WebGL"] },
];

async function check({ name, file, prepare, says }, folder, url, findings) {
  await withPage(async (page) => {
    await standInForCesiumSite(page);
    await prepare?.(page, folder);
    const message = await messageAt(page, file ? pathToFileURL(path.join(folder, "index.html")).href : url);
    for (const part of says(folder)) {
      if (!message.includes(part)) findings.add(`${name}: the page says "${message}", without "${part}"`);
    }
  });
}

async function main() {
  const [argument] = process.argv.slice(2);
  if (!argument) throw new Error("usage: preview_messages.mjs SET_DIR");
  const folder = realpathSync(argument);
  const server = await serve({ "": folder });
  const findings = new Findings();
  try {
    for (const one of CASES) await check(one, folder, server.url, findings);
  } finally {
    server.close();
  }
  findings.report(`the preview page explains itself in ${CASES.length} cases`);
}

await main();
