// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/blocks/chunk_store.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <unistd.h>

namespace qmesh {
namespace {

constexpr int kCells = 16;

float heightOf(std::int64_t i, std::int64_t j) {
  return float((i * 31 + j * 17) % 1009) / 7;
}

/// All tiles of zoom 1 of the geodetic profile, put one by one.
void putWorld(ChunkStore& store, const NodeLattice& lattice) {
  for (std::uint32_t y = 0; y < 2; ++y) {
    for (std::uint32_t x = 0; x < 4; ++x) {
      NodeWindow window;
      window.reset(lattice, {x, y, x, y}, 0);
      for (int b = 0; b < window.height(); ++b) {
        for (int a = 0; a < window.width(); ++a) {
          window.row(b)[a] = heightOf(lattice.wrap(window.column0() + a), window.row0() + b);
        }
      }
      ASSERT_TRUE(store.put(window, {1, x, y}).ok());
    }
  }
}

TEST(ChunkStore, GivesBackEveryNodeAroundTheGlobe) {
  const NodeLattice lattice(Scheme(Profile::geodetic), 1, kCells);
  const std::string file = testing::TempDir() + "chunks.nodes";
  for (const std::int64_t memory : {std::int64_t(1) << 20, std::int64_t(0), std::int64_t(3000)}) {
    MemoryBudget budget(memory);
    {
      ChunkStore store(lattice, budget, file);
      putWorld(store, lattice);
      EXPECT_EQ(access(file.c_str(), F_OK) == 0, memory < (1 << 20));
      NodeWindow window;
      window.reset(lattice, {0, 0, 3, 1}, 12);
      ASSERT_TRUE(store.read(window).ok());
      for (int b = 0; b < window.height(); ++b) {
        const std::int64_t j = window.row0() + b;
        for (int a = 0; a < window.width(); ++a) {
          const float h = window.row(b)[a];
          if (j < 0 || j > lattice.lastRow()) {
            EXPECT_TRUE(std::isnan(h));
          } else {
            EXPECT_EQ(h, heightOf(lattice.wrap(window.column0() + a), j));
          }
        }
      }
    }
    EXPECT_EQ(budget, memory);
    EXPECT_NE(access(file.c_str(), F_OK), 0) << "the temporary file stays";
  }
}

// The east edge of the last tile with data: the tile beyond was never stored.
TEST(ChunkStore, KeepsTheEdgeWhereNoNeighbourIs) {
  const NodeLattice lattice(Scheme(Profile::geodetic), 2, kCells);
  MemoryBudget budget(1 << 20);
  ChunkStore store(lattice, budget, testing::TempDir() + "edge.nodes");
  NodeWindow window;
  window.reset(lattice, {3, 2, 3, 2}, 0);
  for (int b = 0; b < window.height(); ++b)
    std::fill_n(window.row(b), window.width(), 7.0f);
  ASSERT_TRUE(store.put(window, {2, 3, 2}).ok());
  NodeWindow beyond;
  beyond.reset(lattice, {4, 2, 4, 2}, 0);
  ASSERT_TRUE(store.read(beyond).ok());
  EXPECT_EQ(beyond.row(0)[0], 7);
  EXPECT_TRUE(std::isnan(beyond.row(0)[1]));
}

TEST(ChunkStore, SaysWhereItCannotWrite) {
  const NodeLattice lattice(Scheme(Profile::geodetic), 1, kCells);
  MemoryBudget budget(0);
  ChunkStore store(lattice, budget, "/nonexistent-folder/x.nodes");
  NodeWindow window;
  window.reset(lattice, {0, 0, 0, 0}, 0);
  window.row(0)[0] = 1;
  const Status status = store.put(window, {1, 0, 0});
  EXPECT_EQ(status.code(), Code::output);
  EXPECT_NE(status.message().find("/nonexistent-folder/x.nodes"), std::string::npos);
}

} // namespace
} // namespace qmesh
