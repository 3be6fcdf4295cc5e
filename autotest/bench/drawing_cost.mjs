// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
//   node drawing_cost.mjs SET_DIR [FRAMES]
//
// Opens the preview page of a set (-w cesium) in headless Chromium, waits until the view is complete, and prints
// one JSON line: tiles and triangles in the view, and the median milliseconds of FRAMES (30) frames. Chromium
// draws in software here: compare figures of one machine only.
import { withPage } from "../clients/lib/browser.mjs";
import { openPreview, standInForCesiumSite } from "../clients/lib/preview.mjs";
import { serve } from "../clients/lib/server.mjs";

/** In the page: what the globe draws, and how long a frame takes. */
async function measure(frames) {
  const { scene } = window.qmesh.viewer;
  // CesiumJS has no public word for the tiles it draws.
  const tiles = scene.globe._surface._tilesToRender;
  const triangles = tiles.reduce((sum, tile) => sum + tile.data.mesh.indices.length / 3, 0);
  const times = [];
  const pixel = new Uint8Array(4);
  const gl = scene.canvas.getContext("webgl2") ?? scene.canvas.getContext("webgl");
  for (let k = 0; k < frames; ++k) {
    const begin = performance.now();
    scene.requestRender(); // the page draws on demand
    scene.render();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel); // waits until it is drawn
    times.push(performance.now() - begin);
  }
  times.sort((a, b) => a - b);
  return { tiles: tiles.length, triangles, frame_ms: Math.round(times[frames >> 1] * 10) / 10 };
}

const [folder, frames = "30"] = process.argv.slice(2);
const server = await serve({ "": folder });
try {
  await withPage(async (page) => {
    await standInForCesiumSite(page);
    await openPreview(page, server.url);
    console.log(JSON.stringify(await page.evaluate(measure, Number(frames))));
  });
} finally {
  await server.close();
}
