// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Time to mesh one tile of 257 x 257 nodes, on the terrain of the tests or on a real DEM given as
//   QMESH_BENCH_HEIGHTS=FILE:WIDTH   raw float32 rows, north first, as from
//   gdal_translate -of ENVI -ot Float32 dem.tif FILE
// The tolerance of each tile is set so that greedy insertion without decimation makes about the
// asked number of triangles. Counters: triangles made and vertices.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "../cpp/mesh/terrain.h"
#include "mesh/error_measure.h"
#include "mesh/normals.h"
#include "simplify/simplifier.h"

namespace qmesh {
namespace {

constexpr int kCells = 256;
constexpr int kZoom = 12;

NodeLattice benchLattice() {
  return {Scheme(Profile::geodetic), kZoom, kCells};
}

/// The tiles to mesh, all of one raster.
class Ground {
 public:
  Ground() {
    if (const char* given = std::getenv("QMESH_BENCH_HEIGHTS"))
      readFile(given);
    else
      makeTerrain();
  }

  const std::vector<HeightTile>& tiles() const { return tiles_; }

 private:
  void readFile(const std::string& given) {
    const std::size_t colon = given.rfind(':');
    const int width = std::stoi(given.substr(colon + 1));
    std::ifstream file(given.substr(0, colon), std::ios::binary);
    float height = 0;
    while (file.read(reinterpret_cast<char*>(&height), sizeof height))
      heights_.push_back(height);
    cut(width, int(heights_.size()) / width);
  }

  void makeTerrain() {
    const test::TerrainPatch patch(benchLattice(), id(0), 4, 4, test::Terrain::fractal, 1);
    const int width = 4 * kCells + 1 + 2 * kTileHalo;
    const float* first = patch.tile().row(-kTileHalo) - kTileHalo;
    heights_.assign(first, first + width * width);
    cut(width, width);
  }

  /// Whole tiles with their halo; voids become 0. The rows of the file run southwards, so a tile's
  /// row stride is negative.
  void cut(int width, int height) {
    for (float& value : heights_)
      value = value > -12000 && value < 9000 ? value : 0;
    constexpr int size = kCells + 1 + 2 * kTileHalo;
    for (int top = 0; top + size <= height; top += kCells) {
      for (int left = 0; left + size <= width; left += kCells) {
        const float* origin =
            heights_.data() + std::ptrdiff_t(top + kTileHalo + kCells) * width + left + kTileHalo;
        tiles_.emplace_back(id(int(tiles_.size())), benchLattice(), origin, -width);
      }
    }
  }

  static TileId id(int number) { return {kZoom, 1400u + std::uint32_t(number), 2828}; }

  std::vector<float> heights_;
  std::vector<HeightTile> tiles_;
};

const Ground& ground() {
  static const Ground instance;
  return instance;
}

/// Everything about a tile before it is meshed.
struct Prepared {
  LevelParams level;
  TileFrame frame;
  Border border;
};

Prepared prepare(const HeightTile& tile, double maxError) {
  Prepared prepared;
  prepared.level = levelParams(Scheme(Profile::geodetic), kZoom, maxError, kCells);
  prepared.frame.reset(tile, prepared.level);
  makeBorder(tile, prepared.frame, prepared.level, prepared.border);
  return prepared;
}

std::unique_ptr<Simplifier> makeGreedy(bool decimate) {
  MethodOptions options;
  options.decimate = decimate;
  return findSimplifier("greedy")->create(options);
}

/// Per tile of the ground, with the tolerance that gives about `triangles` without decimation.
const std::vector<Prepared>& calibrated(int triangles) {
  static std::map<int, std::vector<Prepared>> known;
  std::vector<Prepared>& all = known[triangles];
  if (!all.empty())
    return all;
  const auto greedy = makeGreedy(false);
  Tin tin;
  for (const HeightTile& tile : ground().tiles()) {
    double low = 0.05, high = 2000;
    for (int step = 0; step < 20; ++step) {
      const double middle = std::sqrt(low * high);
      const Prepared prepared = prepare(tile, middle);
      (void)greedy->simplify(tile, prepared.frame, prepared.border, prepared.level, tin);
      (int(tin.triangles.size()) > triangles ? low : high) = middle;
    }
    all.push_back(prepare(tile, high));
  }
  return all;
}

void simplify(benchmark::State& state, bool decimate) {
  const std::vector<Prepared>& all = calibrated(int(state.range(0)));
  const auto greedy = makeGreedy(decimate);
  Tin tin;
  std::size_t triangles = 0, vertices = 0, tiles = 0;
  for (auto _ : state) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      (void)greedy->simplify(ground().tiles()[k], all[k].frame, all[k].border, all[k].level, tin);
      triangles += tin.triangles.size();
      vertices += tin.vertices.size();
      ++tiles;
    }
  }
  state.SetItemsProcessed(std::int64_t(tiles));
  state.counters["triangles"] = double(triangles) / double(tiles);
  state.counters["vertices"] = double(vertices) / double(tiles);
  state.counters["time/tile"] =
      benchmark::Counter(double(tiles), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void greedyPlain(benchmark::State& state) {
  simplify(state, false);
}
void greedyDecimated(benchmark::State& state) {
  simplify(state, true);
}

/// Runs one step of all tiles and reports the time of one.
template <class Step> void perTile(benchmark::State& state, Step step) {
  std::size_t tiles = 0;
  for (auto _ : state) {
    for (std::size_t k = 0; k < ground().tiles().size(); ++k, ++tiles)
      step(k);
  }
  state.counters["time/tile"] =
      benchmark::Counter(double(tiles), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void frameAndBorder(benchmark::State& state) {
  const std::vector<Prepared>& all = calibrated(2000);
  TileFrame frame;
  Border border;
  perTile(state, [&](std::size_t k) {
    frame.reset(ground().tiles()[k], all[k].level);
    makeBorder(ground().tiles()[k], frame, all[k].level, border);
  });
}

/// One of the steps that follow a TIN.
template <class Step> void afterTin(benchmark::State& state, Step step) {
  const std::vector<Prepared>& all = calibrated(2000);
  const auto greedy = findSimplifier("greedy")->create({});
  std::vector<Tin> tins(all.size());
  for (std::size_t k = 0; k < all.size(); ++k)
    (void)greedy->simplify(ground().tiles()[k], all[k].frame, all[k].border, all[k].level, tins[k]);
  perTile(state, [&](std::size_t k) { step(ground().tiles()[k], all[k].frame, tins[k]); });
}

void measure(benchmark::State& state) {
  afterTin(state, [](const HeightTile& tile, const TileFrame& frame, const Tin& tin) {
    benchmark::DoNotOptimize(measureError(tile, frame, tin));
  });
}

void normals(benchmark::State& state) {
  afterTin(state, [](const HeightTile& tile, const TileFrame& frame, const Tin& tin) {
    benchmark::DoNotOptimize(octNormals(tile, frame, tin));
  });
}

BENCHMARK(greedyPlain)->Arg(500)->Arg(2000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(greedyDecimated)->Arg(500)->Arg(2000)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(frameAndBorder)->Unit(benchmark::kMillisecond);
BENCHMARK(measure)->Unit(benchmark::kMillisecond);
BENCHMARK(normals)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace qmesh
