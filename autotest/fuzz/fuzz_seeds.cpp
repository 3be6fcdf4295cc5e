// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Writes a few valid inputs for each fuzz target, to begin from: fuzz_seeds FOLDER.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "codec/encode.h"
#include "codec/gzip.h"
#include "codec/layer_json.h"

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// A grid of n x n vertices, every cell cut from south-west to north-east.
qmesh::TileMesh gridMesh(std::uint32_t n, bool extensions) {
  qmesh::TileMesh mesh;
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const std::uint32_t column = i % n, row = i / n;
    mesh.u.push_back(std::uint16_t(32767 * column / (n - 1)));
    mesh.v.push_back(std::uint16_t(32767 * row / (n - 1)));
    mesh.q.push_back(std::uint16_t(i * 7919 % 32768));
    if (column == 0)
      mesh.edges[0].push_back(i);
    if (row == 0)
      mesh.edges[1].push_back(i);
    if (column == n - 1)
      mesh.edges[2].push_back(i);
    if (row == n - 1)
      mesh.edges[3].push_back(i);
    if (column < n - 1 && row < n - 1)
      mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + n + 1, i, i + n + 1, i + n});
  }
  mesh.header.maxHeight = 100;
  if (extensions) {
    mesh.extensions.normals.assign(2 * n * n, 128);
    mesh.extensions.waterMask = {255};
    mesh.extensions.metadata = R"({"available":[[{"startX":0,"startY":0,"endX":1,"endY":1}]]})";
  }
  qmesh::orderForEncoding(mesh);
  return mesh;
}

std::string layerText(qmesh::Profile profile, bool full) {
  qmesh::LayerJson layer;
  layer.profile = profile;
  layer.available = {{{0, 0, 0, 0}}, {{0, 0, 1, 1}}};
  layer.maxZoom = 1;
  if (full) {
    layer.name = "a \"name\"";
    layer.slippyMap = true;
    layer.extensions = {"octvertexnormals", "metadata"};
    layer.metadataAvailability = 10;
    layer.method = "greedy";
    layer.levels = {{0, 0.5, 0.25}};
  }
  return qmesh::writeLayerJson(layer);
}

bool writeFile(const fs::path& path, const Bytes& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  return file.good();
}

Bytes bytesOf(const std::string& text) {
  return {text.begin(), text.end()};
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_seeds FOLDER\n");
    return 2;
  }
  const fs::path folder = argv[1];
  qmesh::GzipCompressor gzip;
  bool written = true;
  for (const std::uint32_t n : {2u, 3u, 9u})
    for (const bool extensions : {false, true}) {
      const auto tile = qmesh::encodeTile(gridMesh(n, extensions));
      if (!tile.ok())
        return 1;
      const std::string name = std::to_string(n) + (extensions ? "x" : "");
      written = written && writeFile(folder / "fuzz_decode" / name, *tile) &&
                writeFile(folder / "fuzz_surface" / name, *tile) &&
                writeFile(folder / "fuzz_gunzip" / name, gzip.compress(*tile));
    }
  for (const bool full : {false, true}) {
    const Bytes geodetic = bytesOf(layerText(qmesh::Profile::geodetic, full));
    const Bytes mercator = bytesOf(layerText(qmesh::Profile::mercator, full));
    const std::string suffix = full ? "_full" : "";
    written = written && writeFile(folder / "fuzz_layer_json" / ("geodetic" + suffix), geodetic) &&
              writeFile(folder / "fuzz_layer_json" / ("mercator" + suffix), mercator);
  }
  return written ? 0 : 1;
}
