// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
//   node loaders_all_tiles.mjs SET_DIR
//
// Parses every tile of a set with @loaders.gl/terrain: the counts it finds must be those of
// the file's own header, indices in range, heights within the header's. (It does not read extensions;
// CesiumJS does.)
import { readFile } from "node:fs/promises";
import { gunzipSync } from "node:zlib";
import { parse } from "@loaders.gl/core";
import { QuantizedMeshLoader } from "@loaders.gl/terrain";
import { Findings, allTiles, readLayer, tileFile } from "./lib/checks.mjs";

/** What the file's fixed-size parts say: vertex count, triangle count, height range. */
function headerOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const vertices = view.getUint32(88, true);
  const wide = vertices > 65536;
  let at = 92 + 6 * vertices;
  if (wide) at = Math.ceil(at / 4) * 4;
  return { vertices, triangles: view.getUint32(at, true),
           low: view.getFloat32(24, true), high: view.getFloat32(28, true) };
}

async function tileProblems(file) {
  const raw = await readFile(file);
  const bytes = raw[0] === 0x1f && raw[1] === 0x8b ? gunzipSync(raw) : raw;
  const header = headerOf(bytes);
  const copy = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const mesh = await parse(copy, QuantizedMeshLoader, { worker: false,
    "quantized-mesh": { bounds: [0, 0, 1, 1] } });
  const positions = mesh.attributes.POSITION.value;
  const indices = mesh.indices.value;
  const problems = [];
  const count = (what, found, expected) => {
    if (found !== expected) problems.push(`${found} of ${expected} ${what}`);
  };
  count("vertices", positions.length / 3, header.vertices);
  count("triangles", indices.length / 3, header.triangles);
  if (indices.some((index) => index >= header.vertices)) problems.push("an index beyond the last vertex");
  const slack = 1e-3 + 1e-6 * Math.abs(header.high);
  for (let at = 2; at < positions.length; at += 3) {
    if (!(positions[at] >= header.low - slack && positions[at] <= header.high + slack)) {
      problems.push(`height ${positions[at]} outside ${header.low}..${header.high}`);
      break;
    }
  }
  return { problems, vertices: header.vertices, triangles: header.triangles };
}

async function main() {
  const [folder] = process.argv.slice(2);
  if (!folder) throw new Error("usage: loaders_all_tiles.mjs SET_DIR");
  const layer = await readLayer(folder);
  const findings = new Findings();
  let tiles = 0, vertices = 0, triangles = 0;
  for (const tile of await allTiles(folder, layer)) {
    const name = `${tile.level}/${tile.x}/${tile.y}`;
    try {
      const result = await tileProblems(tileFile(folder, layer, tile));
      findings.addAll(result.problems.map((problem) => `tile ${name}: ${problem}`));
      vertices += result.vertices;
      triangles += result.triangles;
    } catch (error) {
      findings.add(`tile ${name}: ${error.message}`);
    }
    ++tiles;
  }
  if (tiles === 0) findings.add("the set has no tile");
  findings.report(`loaders.gl parses it: ${tiles} tiles, ${vertices} vertices, ${triangles} triangles`);
}

await main();
