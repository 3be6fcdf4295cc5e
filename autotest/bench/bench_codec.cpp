// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Time from a TIN to the bytes of its file: order, encode, gzip; and back. The TINs are greedy
// meshes of random terrain; the argument is the max error in metres. Counters: triangles and bytes.
#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "../cpp/mesh/terrain.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "codec/gzip.h"
#include "mesh/normals.h"
#include "simplify/simplifier.h"

namespace qmesh {
namespace {

constexpr int kCells = 256;

/// A mesh as it comes from the simplifier, not yet in order.
TileMesh makeMesh(double maxError) {
  const NodeLattice lattice(Scheme(Profile::geodetic), 12, kCells);
  const test::TerrainPatch patch(lattice, {12, 1400, 2828}, 1, 1, test::Terrain::fractal, 1);
  const HeightTile tile = patch.tile();
  const LevelParams level = levelParams(lattice.scheme(), lattice.zoom(), maxError, kCells);
  TileFrame frame;
  Border border;
  Tin tin;
  frame.reset(tile, level);
  makeBorder(tile, frame, level, border);
  (void)findSimplifier("greedy")->create({})->simplify(tile, frame, border, level, tin);
  TileMesh mesh;
  for (std::uint32_t k = 0; k < tin.vertices.size(); ++k) {
    const TinVertex& v = tin.vertices[k];
    mesh.u.push_back(v.u);
    mesh.v.push_back(v.v);
    mesh.q.push_back(v.q);
    const std::array<bool, 4> on = {v.u == 0, v.v == 0, v.u == kQuantizedMax, v.v == kQuantizedMax};
    for (std::size_t edge = 0; edge < 4; ++edge) {
      if (on[edge])
        mesh.edges[edge].push_back(k);
    }
  }
  for (const TinTriangle& t : tin.triangles)
    mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
  mesh.extensions.normals = octNormals(tile, frame, tin);
  return mesh;
}

TileMesh ordered(TileMesh mesh) {
  orderForEncoding(mesh);
  return mesh;
}

void order(benchmark::State& state) {
  const TileMesh mesh = makeMesh(double(state.range(0)));
  for (auto _ : state) {
    TileMesh copy = mesh;
    orderForEncoding(copy);
    benchmark::DoNotOptimize(copy.indices.data());
  }
  state.counters["triangles"] = double(mesh.triangleCount());
}

void encode(benchmark::State& state) {
  const TileMesh mesh = ordered(makeMesh(double(state.range(0))));
  for (auto _ : state)
    benchmark::DoNotOptimize(encodeTile(mesh));
  state.counters["bytes"] = double(encodeTile(mesh)->size());
}

void gzip(benchmark::State& state) {
  const auto bytes = encodeTile(ordered(makeMesh(double(state.range(0)))));
  GzipCompressor compressor;
  for (auto _ : state)
    benchmark::DoNotOptimize(compressor.compress(*bytes));
  state.counters["bytes"] = double(compressor.compress(*bytes).size());
}

void decode(benchmark::State& state) {
  const auto bytes = encodeTile(ordered(makeMesh(double(state.range(0)))));
  for (auto _ : state)
    benchmark::DoNotOptimize(decodeTile(bytes->data(), bytes->size()));
}

BENCHMARK(order)->Arg(40)->Arg(10)->Arg(3)->Unit(benchmark::kMicrosecond);
BENCHMARK(encode)->Arg(40)->Arg(10)->Arg(3)->Unit(benchmark::kMicrosecond);
BENCHMARK(gzip)->Arg(40)->Arg(10)->Arg(3)->Unit(benchmark::kMicrosecond);
BENCHMARK(decode)->Arg(40)->Arg(10)->Arg(3)->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace qmesh
