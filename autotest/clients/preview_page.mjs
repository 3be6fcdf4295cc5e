// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
//   node preview_page.mjs SET_DIR [--switches] [--no-encoding] [--screenshots PREFIX]
//
// Opens the preview page of a set in Chromium and looks at the pixels: terrain with relief, no magenta, no
// error in the console, no file missing. The read-out under the mouse must agree with CesiumJS's own
// sampling. --switches: works every switch, with a picture each.
// --no-encoding: the server does not announce gzip, as `python3 -m http.server`.
// --screenshots: keep the pictures as PREFIX-NAME.png.
import { writeFile } from "node:fs/promises";
import { Findings, parseArguments } from "./lib/checks.mjs";
import { cesiumFolder, withPage } from "./lib/browser.mjs";
import { pictureProblems, pixelFacts } from "./lib/pixels.mjs";
import { openPreview, settle, standInForCesiumSite } from "./lib/preview.mjs";
import { serve } from "./lib/server.mjs";

const SIZE = { width: 1024, height: 768 };
// Right of the panel and above the read-out: nothing but terrain.
const TERRAIN = { x: 300, y: 20, width: SIZE.width - 320, height: SIZE.height - 140 };

class PageTest {
  constructor(page, findings, prefix) { Object.assign(this, { page, findings, prefix, pictures: {} }); }

  /**
   * Takes a picture of the terrain and judges it. `drawn`: share of the pixels that must not be background;
   * `relief`: whether it must have many colours (flat sea, unlit, has one).
   */
  async picture(name, { drawn = 0.15, relief = true } = {}) {
    await settle(this.page);
    if (this.prefix) await writeFile(`${this.prefix}-${name}.png`, await this.page.screenshot());
    const png = await this.page.screenshot({ clip: TERRAIN });
    const problems = pictureProblems(await pixelFacts(this.page, png), { drawn, relief });
    this.findings.addAll(problems.map((problem) => `picture "${name}": ${problem}`));
    this.pictures[name] = png.toString("base64");
  }

  differs(name, other) {
    if (this.pictures[name] === this.pictures[other]) {
      this.findings.add(`picture "${name}" is the same as "${other}": the switch does nothing`);
    }
  }

  same(name, other) {
    if (this.pictures[name] !== this.pictures[other]) {
      this.findings.add(`picture "${name}" should be "${other}" again`);
    }
  }

  async toggle(id) { await this.page.locator(`#${id}`).click(); }

  async exaggerate(value) {
    await this.page.locator("#exaggeration").fill(String(value));
  }
}

async function checkSwitches(test) {
  await test.toggle("light");
  await test.picture("unlit", { relief: false });
  test.differs("unlit", "home");
  await test.toggle("light");
  await test.toggle("wireframe");
  await test.picture("wireframe", { drawn: 0.02 });
  test.differs("wireframe", "home");
  await test.toggle("wireframe");
  await test.toggle("borders");
  await test.picture("borders");
  test.differs("borders", "home");
  await test.page.locator("#globe canvas").focus();
  await test.page.keyboard.press("b");
  await test.picture("home-again");
  test.same("home-again", "home");
  await test.exaggerate(60);
  await test.picture("exaggerated");
  test.differs("exaggerated", "home");
  await test.exaggerate(0);
}

/** The height shown under the mouse against the one CesiumJS samples there at the level shown. */
async function checkReadout(test) {
  await test.page.mouse.move(TERRAIN.x + TERRAIN.width / 2, TERRAIN.y + TERRAIN.height / 2);
  await settle(test.page);
  const text = await test.page.locator("#place").textContent();
  const number = "([\\d\\u202f.\u2212]+)";
  const parts = new RegExp(
    `^${number}° ([NS]) · ${number}° ([EW]) · ${number} m · level (\\d+)$`).exec(text);
  if (!parts) {
    test.findings.add(`the read-out says "${text}"`);
    return;
  }
  const value = (at) => Number(parts[at].replaceAll("\u202f", "").replace("\u2212", "-"));
  const lat = value(1) * (parts[2] === "S" ? -1 : 1), lon = value(3) * (parts[4] === "W" ? -1 : 1);
  const expected = await test.page.evaluate(async ([x, y, level]) => {
    const place = Cesium.Cartographic.fromDegrees(x, y);
    await Cesium.sampleTerrain(window.qmesh.viewer.terrainProvider, level, [place]);
    return place.height;
  }, [lon, lat, value(6)]);
  // The place is shown to 1e-5 degrees, about 1 m: allow for steep ground.
  if (!(Math.abs(value(5) - expected) < 3)) {
    test.findings.add(`the read-out says ${value(5)} m at ${lon} ${lat}, CesiumJS ${expected} m`);
  }
  const drawn = await test.page.locator("#drawn").textContent();
  if (!/^levels to \d+ · [\d\u202f]+ tiles? · [\d\u202f]+ triangles?$/.test(drawn)) {
    test.findings.add(`the line about what is drawn says "${drawn}"`);
  }
}

async function main() {
  const { positional: [folder], options } =
    parseArguments(process.argv.slice(2), ["no-encoding", "switches"]);
  if (!folder) throw new Error("usage: preview_page.mjs SET_DIR [--switches] [--no-encoding]");
  const server = await serve({ "": folder }, { encoding: !options["no-encoding", "switches"] });
  const findings = new Findings();
  try {
    await withPage(async (page, problems) => {
      await standInForCesiumSite(page);
      await openPreview(page, server.url);
      const test = new PageTest(page, findings, options.screenshots);
      await test.picture("home");
      await checkReadout(test);
      if (options.switches) await checkSwitches(test);
      findings.addAll(problems);
    }, SIZE);
  } finally {
    server.close();
  }
  findings.addAll(server.failures.map((path) => `not found: ${path}`));
  findings.report("the preview page shows it");
}

await main();
