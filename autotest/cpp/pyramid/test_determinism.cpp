// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Promise P3: the cutting of the work cannot change a byte.
#include "synthetic.h"

namespace qmesh {
namespace {

using synthetic::Sink;
using synthetic::Source;

bool speckle(double lon, double lat) {
  const double a = std::floor(lon * 3), b = std::floor(lat * 3);
  return std::fmod(std::abs(a * 7 + b * 13), 5) < 1 || (lon > 12 && lon < 25 && lat > 5);
}

/// Builds the same set in many ways and compares every file.
void expectSameFromEveryWay(BuildOptions options, const Source& source) {
  options.run.blockTiles = 8;
  Sink reference;
  synthetic::build(options, source, reference);
  ASSERT_GT(reference.files.size(), 10u);
  struct Way {
    int blockTiles;
    int threads;
    bool spill;
  };
  for (const Way& way : {Way{2, 1, false}, Way{4, 1, false}, Way{8, 3, false}, Way{2, 4, true},
                         Way{4, 2, true}, Way{8, 1, true}}) {
    options.run.blockTiles = way.blockTiles;
    options.run.threads = way.threads;
    Sink sink;
    synthetic::build(options, source, sink, [&](BlockPlan& blocks) {
      if (way.spill)
        blocks.storeBytes = 700;
    });
    ASSERT_EQ(sink.files.size(), reference.files.size());
    for (const auto& file : reference.files) {
      ASSERT_EQ(sink.files[file.first], file.second)
          << file.first << " differs with blocks of " << way.blockTiles << ", " << way.threads
          << " threads, spilling " << way.spill;
    }
  }
}

/// Every combination of what could depend on the cutting.
void tryEveryFilter(BuildOptions options, const Source& source) {
  for (const auto filter :
       {OverviewResampling::nearest, OverviewResampling::average, OverviewResampling::cubic}) {
    for (const auto fill : {VoidFill::value, VoidFill::interpolate}) {
      options.tiling.overviewResampling = filter;
      options.heights.voidFill = fill;
      expectSameFromEveryWay(options, source);
    }
  }
}

TEST(Determinism, GlobalWithVoids) {
  Source source;
  source.boxes = {{-180, -90, 180, 90}};
  source.zoom = 4;
  source.isVoid = speckle;
  tryEveryFilter(synthetic::smallOptions(), source);
}

TEST(Determinism, AcrossTheAntimeridianInMercator) {
  Source source;
  source.boxes = {{171.3, -12.1, 187.9, 9.7}};
  source.zoom = 6;
  source.isVoid = speckle;
  BuildOptions options = synthetic::smallOptions();
  options.tiling.profile = Profile::mercator;
  tryEveryFilter(options, source);
}

TEST(Determinism, FarApartBoxesOnTileEdges) {
  Source source;
  source.boxes = {{0, 0, 22.5, 11.25}, {33.75, -22.5, 45, -11.25}, {-91.3, 44.9, -77.7, 51.2}};
  source.zoom = 6;
  source.isVoid = speckle;
  tryEveryFilter(synthetic::smallOptions(), source);
}

TEST(Determinism, ExcludedVoidsAndMetadata) {
  Source source;
  source.boxes = {{-30, -20, 40, 30}};
  source.zoom = 6;
  source.isVoid = speckle;
  BuildOptions options = synthetic::smallOptions();
  options.tiling.excludeVoid = true;
  options.output.metadata = 2;
  expectSameFromEveryWay(options, source);
  options.heights.voidFill = VoidFill::interpolate;
  expectSameFromEveryWay(options, source);
}

TEST(Determinism, PartOfTheTilesAndNoLevelZero) {
  Source source;
  source.boxes = {{-30, -20, 40, 30}};
  source.zoom = 6;
  source.isVoid = speckle;
  BuildOptions options = synthetic::smallOptions();
  options.tiling.minX = 59;
  options.tiling.maxX = 67;
  options.tiling.minY = 27;
  options.tiling.minZoom = 2;
  expectSameFromEveryWay(options, source);
  options.heights.voidFill = VoidFill::interpolate;
  expectSameFromEveryWay(options, source);
}

} // namespace
} // namespace qmesh
