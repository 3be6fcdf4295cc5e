// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
import { existsSync } from "node:fs";
import { mkdtemp, rm } from "node:fs/promises";
import os from "node:os";
import path from "node:path";
import { chromium } from "playwright-core";

const FLAGS = [
  "--no-sandbox", "--disable-gpu", "--use-gl=angle", "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync",
];
const PLACES = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** Node's package folder of CesiumJS, as the page's `Cesium/` folder. */
export const cesiumFolder = path.join(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname),
  "../node_modules/cesium/Build/Cesium");

export function chromiumProgram() {
  const program = process.env.QMESH_CHROMIUM ?? PLACES.find((place) => existsSync(place));
  if (!program) throw new Error("no Chromium found: install Debian's chromium or set QMESH_CHROMIUM");
  return program;
}

/**
 * Runs `work(page, problems)` in a fresh headless Chromium. `problems` fills with console errors and
 * uncaught exceptions as they come; warnings of the driver about software rendering are not among them.
 */
export async function withPage(work, { width = 1024, height = 768 } = {}) {
  const profile = await mkdtemp(path.join(os.tmpdir(), "qmesh-chromium-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: chromiumProgram(), headless: true, args: FLAGS, viewport: { width, height },
  });
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(240_000);
    const problems = [];
    page.on("console", (line) => {
      if (line.type() === "error") problems.push(`console: ${line.text()} ${line.location().url ?? ""}`);
    });
    page.on("pageerror", (error) => problems.push(`exception: ${error.message}`));
    return await work(page, problems);
  } finally {
    await context.close();
    await rm(profile, { recursive: true, force: true });
  }
}
