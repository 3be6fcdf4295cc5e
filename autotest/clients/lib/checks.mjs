// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
import { readFile, readdir } from "node:fs/promises";
import path from "node:path";

/** Collects what went wrong; at most a few lines of each kind reach the reader. */
export class Findings {
  #lines = [];
  add(line) { this.#lines.push(line); }
  addAll(lines) { lines.forEach((line) => this.add(line)); }
  get count() { return this.#lines.length; }

  /** Prints the findings and sets the exit code of the process. */
  report(doneSentence) {
    const most = 20;
    for (const line of this.#lines.slice(0, most)) console.error(`FAILED ${line}`);
    if (this.count > most) console.error(`... and ${this.count - most} more`);
    if (this.count > 0) process.exitCode = 1;
    else console.log(doneSentence);
  }
}

export async function readLayer(folder) {
  return JSON.parse(await readFile(path.join(folder, "layer.json"), "utf8"));
}

/** Every tile of layer.json's `available` as {level, x, y}, y from the south, as layer.json counts. */
function* listedTiles(layer) {
  for (const [level, ranges] of layer.available.entries()) {
    for (const { startX, startY, endX, endY } of ranges) {
      for (let y = startY; y <= endY; ++y) {
        for (let x = startX; x <= endX; ++x) yield { level, x, y };
      }
    }
  }
}

/** Every tile on disk, rows from the south. */
async function tilesOnDisk(folder, layer) {
  const tiles = [];
  for (const file of await readdir(folder, { recursive: true })) {
    const parts = /^(\d+)\/(\d+)\/(\d+)\.terrain$/.exec(file.replaceAll(path.sep, "/"));
    if (!parts) continue;
    const [level, x, row] = parts.slice(1).map(Number);
    tiles.push({ level, x, y: flipped(layer, level, row) });
  }
  return tiles.sort((a, b) => a.level - b.level || a.y - b.y || a.x - b.x);
}

/**
 * Every tile of a set, level by level from 0: those layer.json lists, or, where tiles list their descendants
 * themselves (metadataAvailability), those on disk.
 */
export async function allTiles(folder, layer) {
  return layer.metadataAvailability ? tilesOnDisk(folder, layer) : [...listedTiles(layer)];
}

/** A row counted from the south as the URL counts it, and back; both profiles have 2^level rows. */
function flipped(layer, level, row) {
  return layer.scheme === "slippyMap" ? 2 ** level - 1 - row : row;
}

/** The file of a tile, from the URL template of layer.json. */
export function tileFile(folder, layer, { level, x, y }) {
  const name = layer.tiles[0].split("?")[0]
    .replace("{z}", level).replace("{x}", x).replace("{y}", flipped(layer, level, y));
  return path.join(folder, name);
}

/** Splits ARGV into positional arguments and --name value pairs; flags without value in `flags`. */
export function parseArguments(argv, flags = []) {
  const positional = [], options = {};
  for (let at = 0; at < argv.length; ++at) {
    if (!argv[at].startsWith("--")) positional.push(argv[at]);
    else if (flags.includes(argv[at].slice(2))) options[argv[at].slice(2)] = true;
    else options[argv[at].slice(2)] = argv[++at];
  }
  return { positional, options };
}
