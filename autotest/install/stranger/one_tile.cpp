// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// one_tile FILE: writes the tile 9/270/360 of a land that is flat, 250 m high, but for one hill of
// 90 m in its middle.
#include <cmath>
#include <cstdio>
#include <vector>

#include <qmesh/pyramid/tile_job.h>
#include <qmesh/vsi/vsi_files.h>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: one_tile FILE\n", stderr);
    return 2;
  }
  constexpr int kCells = 64;
  constexpr int kStride = kCells + 1 + 2 * qmesh::kTileHalo;
  std::vector<float> heights(kStride * kStride);
  for (int j = 0; j < kStride; ++j) {
    for (int i = 0; i < kStride; ++i) {
      const double x = i - kStride / 2, y = j - kStride / 2;
      heights[std::size_t(j * kStride + i)] = float(250 + 90 * std::exp(-(x * x + y * y) / 50));
    }
  }
  const qmesh::Scheme scheme(qmesh::Profile::geodetic);
  const qmesh::TileId id{9, 270, 360};
  const qmesh::NodeLattice lattice(scheme, id.z, kCells);
  const float* origin = heights.data() + qmesh::kTileHalo * (kStride + 1);
  const qmesh::HeightTile tile(id, lattice, origin, kStride);

  // Method greedy, normals, gzip.
  qmesh::TileJob job(qmesh::MethodOptions{}, qmesh::OutputOptions{});
  qmesh::TileResult result;
  qmesh::StepSeconds seconds{};
  const qmesh::LevelParams level = qmesh::levelParams(scheme, id.z, 1.0, kCells);
  qmesh::Status status = job.run(tile, level, nullptr, result, seconds);
  if (status.ok())
    status = qmesh::writeWholeFile(argv[1], result.bytes.data(), result.bytes.size());
  if (!status.ok()) {
    std::fprintf(stderr, "one_tile: %s\n", status.message().c_str());
    return int(status.code());
  }
  std::printf("%llu triangles, largest error %.3f m\n",
              static_cast<unsigned long long>(result.stats.triangles), result.stats.maxError);
  return 0;
}
