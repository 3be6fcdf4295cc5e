// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
//   node cesium_all_tiles.mjs SET_DIR [--samples samples.json] [--no-encoding]
//
// Loads every tile of a set with CesiumJS in a real Chromium: requestTileGeometry and
// createMesh for each, no error, no line in the console. --samples: a JSON list of {lon, lat, height,
// tolerance} (degrees, metres); sampleTerrainMostDetailed must give each height. --no-encoding: serve
// without Content-Encoding: CesiumJS alone then reads only sets that are not compressed.
import { readFile } from "node:fs/promises";
import { Findings, allTiles, parseArguments, readLayer } from "./lib/checks.mjs";
import { cesiumFolder, withPage } from "./lib/browser.mjs";
import { serve } from "./lib/server.mjs";

const TILES_AT_ONCE = 64;

/** In the browser: meshes some tiles; an error sentence for each that fails. */
async function meshTiles(tiles) {
  const { provider } = window;
  const rowsAt = (level) => provider.tilingScheme.getNumberOfYTilesAtLevel(level);
  const failures = [];
  let triangles = 0;
  await Promise.all(tiles.map(async ({ level, x, y }) => {
    const row = rowsAt(level) - 1 - y;
    const name = `${level}/${x}/${y}`;
    try {
      if (!provider.getTileDataAvailable(x, row, level)) throw new Error("is not reported as available");
      const data = await provider.requestTileGeometry(x, row, level);
      const mesh = await data.createMesh({
        tilingScheme: provider.tilingScheme, x, y: row, level, exaggeration: 1,
        exaggerationRelativeHeight: 0, throttle: false });
      const shown = mesh.indexCountWithoutSkirts / 3;
      if (!(shown >= 2)) throw new Error(`has ${shown} triangles`);
      if (!(mesh.boundingSphere3D.radius > 0)) throw new Error("has no bounding sphere");
      if (!mesh.vertices.every(Number.isFinite)) throw new Error("has vertices that are not numbers");
      if (mesh.encoding.hasVertexNormals !== provider.hasVertexNormals) {
        throw new Error("normals are announced but not there");
      }
      triangles += shown;
    } catch (error) {
      failures.push(`tile ${name}: ${error.message ?? error}`);
    }
  }));
  return { failures, triangles };
}

/** In the browser: the heights CesiumJS finds at places in degrees; null where it finds none. */
async function heightsAt(places) {
  const positions = places.map(({ lon, lat }) => Cesium.Cartographic.fromDegrees(lon, lat));
  await Cesium.sampleTerrainMostDetailed(window.provider, positions);
  return positions.map((position) => position.height ?? null);
}

async function openProvider(page, url) {
  await page.goto(url + "client-test-page/");
  await page.evaluate(async (set) => {
    window.CESIUM_BASE_URL = "/Cesium/";
    await new Promise((resolve, reject) => {
      const script = Object.assign(document.createElement("script"), {
        src: "/Cesium/Cesium.js", onload: resolve, onerror: () => reject(new Error("no Cesium.js")) });
      document.head.append(script);
    });
    Cesium.RequestScheduler.throttleRequests = false;
    window.provider = await Cesium.CesiumTerrainProvider.fromUrl(set, {
      requestVertexNormals: true, requestWaterMask: true, requestMetadata: true });
  }, url);
}

/** Groups of a few tiles of one level: the metadata of a level must be there before the next one's turn. */
function* portions(tiles) {
  let portion = [];
  for (const tile of tiles) {
    if (portion.length === TILES_AT_ONCE || (portion[0] && portion[0].level !== tile.level)) {
      yield portion;
      portion = [];
    }
    portion.push(tile);
  }
  if (portion.length > 0) yield portion;
}

async function checkTiles(page, folder, findings) {
  const layer = await readLayer(folder);
  const tiles = await allTiles(folder, layer);
  let triangles = 0;
  for (const portion of portions(tiles)) {
    const result = await page.evaluate(meshTiles, portion);
    findings.addAll(result.failures);
    triangles += result.triangles;
  }
  if (tiles.length === 0) findings.add("the set has no tile");
  const announced = (layer.extensions ?? []).includes("octvertexnormals");
  const hasNormals = await page.evaluate(() => window.provider.hasVertexNormals);
  if (announced !== hasNormals) {
    findings.add(`normals announced: ${announced}, seen by CesiumJS: ${hasNormals}`);
  }
  return `${tiles.length} tiles, ${triangles} triangles`;
}

async function checkSamples(page, file, findings) {
  const places = JSON.parse(await readFile(file, "utf8"));
  const heights = await page.evaluate(heightsAt, places);
  let worst = 0;
  places.forEach(({ lon, lat, height, tolerance }, at) => {
    const off = heights[at] === null ? Infinity : Math.abs(heights[at] - height);
    worst = Math.max(worst, off / tolerance);
    if (!(off <= tolerance)) {
      findings.add(`height at ${lon} ${lat}: ${heights[at]} instead of ${height} +- ${tolerance}`);
    }
  });
  return `${places.length} heights, the worst at ${worst.toFixed(2)} of its tolerance`;
}

async function main() {
  const { positional: [folder], options } = parseArguments(process.argv.slice(2), ["no-encoding"]);
  if (!folder) throw new Error("usage: cesium_all_tiles.mjs SET_DIR [--samples FILE] [--no-encoding]");
  const emptyPage = new URL("./lib/", import.meta.url).pathname;
  const mounts = { "": folder, Cesium: cesiumFolder, "client-test-page": emptyPage };
  const server = await serve(mounts, { encoding: !options["no-encoding"] });
  const findings = new Findings();
  const done = [];
  try {
    await withPage(async (page, problems) => {
      await openProvider(page, server.url);
      done.push(await checkTiles(page, folder, findings));
      if (options.samples) done.push(await checkSamples(page, options.samples, findings));
      findings.addAll(problems);
    });
  } finally {
    server.close();
  }
  findings.addAll(server.failures.map((path) => `not found: ${path}`));
  findings.report(`CesiumJS loads it: ${done.join("; ")}`);
}

await main();
