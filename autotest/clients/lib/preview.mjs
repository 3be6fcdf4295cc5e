// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
import { readFile } from "node:fs/promises";
import path from "node:path";
import { cesiumFolder } from "./browser.mjs";

const RELEASES = /^https:\/\/cesium\.com\/downloads\/cesiumjs\/releases\/([\d.]+)\/Build\/Cesium\/([^?]*)/;

/** The version number of the CesiumJS the tests run, as its download site writes it ("1.145"). */
export async function installedRelease() {
  const description = path.join(cesiumFolder, "../../package.json");
  return JSON.parse(await readFile(description, "utf8")).version.replace(/\.0$/, "");
}

/**
 * Answers requests to CesiumJS's download site from the installed package, with that site's manners (another
 * origin that permits everyone), so that the page as shipped is tested without network. A request for
 * another version fails.
 */
export async function standInForCesiumSite(page) {
  const release = await installedRelease();
  await page.route(RELEASES, async (route) => {
    const [, version, name] = RELEASES.exec(route.request().url());
    if (version !== release) return route.abort();
    return route.fulfill({ path: path.join(cesiumFolder, decodeURIComponent(name)),
                           headers: { "Access-Control-Allow-Origin": "*" } });
  });
}

/** Opens the page and waits until it shows the terrain; throws with the page's own message otherwise. */
export async function openPreview(page, url) {
  await page.goto(url);
  await page.evaluate(() => window.qmesh.ready);
  await settle(page);
}

/** Waits until all tiles of the view are loaded and drawn. */
export async function settle(page) {
  await page.evaluate(async () => {
    const { scene } = window.qmesh.viewer;
    const oneFrame = () => new Promise((resolve) => {
      const stop = scene.postRender.addEventListener(() => { stop(); resolve(); });
      scene.requestRender();
    });
    let quiet = 0;
    while (quiet < 3) {
      await oneFrame();
      quiet = scene.globe.tilesLoaded ? quiet + 1 : 0;
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  });
}
