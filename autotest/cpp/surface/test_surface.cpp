// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../codec/random_mesh.h"
#include "surface/surface_raster.h"
#include "surface/surface_search.h"

namespace qmesh {
namespace {

const Scheme kGeodetic{Profile::geodetic};
const Scheme kMercator{Profile::mercator};
const Registration kBoth[] = {Registration::cell, Registration::node};

/// A mesh of given vertices, heights 0..32767 m so that q is the height.
TileMesh meshOf(std::vector<std::array<int, 3>> vertices, std::vector<std::uint32_t> indices) {
  TileMesh mesh;
  mesh.header.maxHeight = 32767;
  for (const auto& [u, v, q] : vertices) {
    mesh.u.push_back(std::uint16_t(u));
    mesh.v.push_back(std::uint16_t(v));
    mesh.q.push_back(std::uint16_t(q));
  }
  mesh.indices = std::move(indices);
  return mesh;
}

//  3---2
//  | / |   q = u
//  0---1
TileMesh ramp() {
  return meshOf({{0, 0, 0}, {32767, 0, 32767}, {32767, 32767, 32767}, {0, 32767, 0}},
                {0, 1, 2, 0, 2, 3});
}

TEST(SurfaceRaster, CellsLieInTheMiddleAndNodesOnTheCorners) {
  const auto cells = rasterHeights(ramp(), {kGeodetic, {3, 5, 2}, 4, Registration::cell});
  ASSERT_EQ(cells.size(), 16u);
  const auto nodes = rasterHeights(ramp(), {kGeodetic, {3, 5, 2}, 4, Registration::node});
  ASSERT_EQ(nodes.size(), 25u);
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      EXPECT_FLOAT_EQ(cells[4 * row + column], float(32767 * (double(column) + 0.5) / 4));
  for (std::size_t row = 0; row < 5; ++row)
    for (std::size_t column = 0; column < 5; ++column)
      EXPECT_FLOAT_EQ(nodes[5 * row + column], float(32767 * double(column) / 4));
}

TEST(SurfaceRaster, RowsOfAMercatorRasterAreEvenInMercatorY) {
  TileMesh mesh = ramp();
  mesh.q = {0, 0, 32767, 32767}; // v, which is linear in latitude
  const TileId tile{1, 0, 1};
  const GeoBox box = kMercator.box(tile);
  const auto heights = rasterHeights(mesh, {kMercator, tile, 8, Registration::cell});
  for (int row = 0; row < 8; ++row) {
    const double latitude = kMercator.latitude(2 * (8 + row) + 1, 32);
    EXPECT_FLOAT_EQ(heights[std::size_t(row) * 8],
                    float(32767 * (latitude - box.south) / (box.north - box.south)));
  }
}

/// Every place once: the raster agrees with a search, which knows nothing of spans.
TEST(SurfaceRaster, AgreesWithTheSearchOnRandomMeshes) {
  std::mt19937 random(7);
  for (int k = 0; k < 40; ++k) {
    const TileMesh mesh =
        test::randomMesh(random, 2 + random() % 12, 2 + random() % 12, random() % 40);
    const SurfaceSearch search(mesh);
    for (const Registration registration : kBoth) {
      const TilePlaces places(kMercator, {5, 7, 21}, 1 + int(random() % 70), registration);
      const auto heights = rasterHeights(mesh, places);
      const double range = double(mesh.header.maxHeight) - mesh.header.minHeight;
      for (int row = 0; row < places.side(); ++row) {
        for (int column = 0; column < places.side(); ++column) {
          const double u = (column + (registration == Registration::cell ? 0.5 : 0)) * 32767 /
                           places.columnsPerTile();
          const auto height = search.heightAt(u, places.rowV()[std::size_t(row)]);
          ASSERT_TRUE(height);
          ASSERT_NEAR(heights[std::size_t(row * places.side() + column)], *height,
                      1e-6 * std::abs(range) + 1e-7 * std::abs(*height))
              << k << ": " << column << ", " << row;
        }
      }
    }
  }
}

TEST(SurfaceRaster, AnAncestorsPartIsThePartOfItsRaster) {
  std::mt19937 random(8);
  const TileMesh mesh = test::randomMesh(random, 9, 9, 30);
  const TileId ancestor{4, 9, 6};
  for (const Scheme& scheme : {kGeodetic, kMercator}) {
    const auto whole = rasterHeights(mesh, {scheme, ancestor, 64, Registration::cell});
    for (std::uint32_t y = 0; y < 4; ++y) {
      for (std::uint32_t x = 0; x < 4; ++x) {
        const TileId tile{6, 4 * ancestor.x + x, 4 * ancestor.y + y};
        const auto part = rasterHeights(mesh, {scheme, tile, ancestor, 16, Registration::cell});
        for (std::size_t row = 0; row < 16; ++row)
          for (std::size_t column = 0; column < 16; ++column)
            ASSERT_NEAR(part[16 * row + column], whole[64 * (16 * y + row) + 16 * x + column],
                        1e-5);
      }
    }
  }
}

TEST(SurfaceRaster, TheFarthestAncestorStillFits) {
  const TileId tile{24, (1u << 25) - 1, (1u << 24) - 1};
  const auto heights =
      rasterHeights(ramp(), {kGeodetic, tile, {4, 31, 15}, 1024, Registration::node});
  EXPECT_FLOAT_EQ(heights.front(), float(32767 * (1 - 1.0 / (1 << 20))));
  EXPECT_FLOAT_EQ(heights.back(), 32767);
}

//  3---2     triangles: one turning the wrong way, one without area, and half the square empty
//  |  /
//  | /
//  0   1
TEST(SurfaceRaster, ForeignMeshes) {
  TileMesh mesh = ramp();
  mesh.indices = {0, 3, 2, 0, 0, 2, 0, 2, 0};
  const auto heights = rasterHeights(mesh, {kGeodetic, {0, 0, 0}, 8, Registration::cell});
  const SurfaceSearch search(mesh);
  for (std::size_t row = 0; row < 8; ++row) {
    for (std::size_t column = 0; column < 8; ++column) {
      const float height = heights[8 * row + column];
      const auto found =
          search.heightAt((double(column) + 0.5) * 32767 / 8, (double(row) + 0.5) * 32767 / 8);
      if (column > row) {
        EXPECT_TRUE(std::isnan(height));
        EXPECT_FALSE(found);
      } else if (column < row) { // the diagonal itself belongs to the missing half
        EXPECT_FLOAT_EQ(height, float((double(column) + 0.5) * 32767 / 8));
        EXPECT_FLOAT_EQ(float(found.value_or(-1)), height);
      }
    }
  }
}

TEST(SurfaceSearch, SliversAcrossTheTileNeedNoMoreMemory) {
  TileMesh mesh;
  for (int k = 0; k < 20000; ++k) {
    mesh.u.push_back(std::uint16_t(k % 2 ? 32767 : 0));
    mesh.v.push_back(std::uint16_t(k % 2 ? 32767 - k : k));
    mesh.q.push_back(0);
  }
  for (std::uint32_t k = 0; k + 2 < mesh.u.size(); ++k)
    mesh.indices.insert(mesh.indices.end(), {k, k + 1, k + 2});
  const SurfaceSearch search(mesh);
  EXPECT_TRUE(search.heightAt(16000, 16000));
}

TEST(SurfaceSearch, PlacesOutsideHaveNoHeight) {
  const TileMesh mesh = ramp();
  const SurfaceSearch search(mesh);
  EXPECT_TRUE(search.heightAt(0, 0));
  EXPECT_TRUE(search.heightAt(32767, 32767));
  EXPECT_FALSE(search.heightAt(-0.5, 10));
  EXPECT_FALSE(search.heightAt(10, 32767.5));
  EXPECT_FALSE(search.heightAt(std::nan(""), 10));
}

} // namespace
} // namespace qmesh
