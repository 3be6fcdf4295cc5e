// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "grid/reduce.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <random>

namespace qmesh {
namespace {

constexpr int kCells = 8;

/// A height that is a function of the node alone; every seventh or so is void.
float heightOf(std::int64_t i, std::int64_t j, bool voids) {
  std::uint64_t k = std::uint64_t(i * 73856093) ^ std::uint64_t(j * 19349663);
  k = (k ^ (k >> 13)) * 0x9e3779b97f4a7c15u;
  if (voids && (k >> 60) < 3)
    return NAN;
  return float(k >> 40) / 1000.0f;
}

NodeWindow filledWindow(const NodeLattice& lattice, const TileRange& tiles, int halo, bool voids) {
  NodeWindow window;
  window.reset(lattice, tiles, halo);
  for (int b = window.firstExistingRow(); b < window.endExistingRow(); ++b) {
    for (int a = 0; a < window.width(); ++a) {
      window.row(b)[a] = heightOf(lattice.wrap(window.column0() + a), window.row0() + b, voids);
    }
  }
  return window;
}

/// The definition, in double precision and without a thought for speed.
double oracle(const NodeLattice& fine, std::int64_t i, std::int64_t j, OverviewResampling filter,
              bool voids) {
  const auto node = [&](std::int64_t di, std::int64_t dj) -> double {
    const std::int64_t row = 2 * j + dj;
    if (row < 0 || row > fine.lastRow())
      return NAN;
    return heightOf(fine.wrap(2 * i + di), row, voids);
  };
  if (filter == OverviewResampling::nearest)
    return node(0, 0);
  if (filter == OverviewResampling::cubic) {
    const double w[4] = {16, 9, 0, -1};
    double sum = 0;
    for (int dj = -3; dj <= 3; ++dj) {
      for (int di = -3; di <= 3; ++di)
        sum += w[std::abs(di)] * w[std::abs(dj)] * node(di, dj);
    }
    if (!std::isnan(sum))
      return sum / 1024;
  }
  double sum = 0;
  double weight = 0;
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      const double w = (2 - std::abs(di)) * (2 - std::abs(dj));
      if (std::isnan(node(di, dj)))
        continue;
      sum += w * node(di, dj);
      weight += w;
    }
  }
  return weight >= 8 ? sum / weight : NAN;
}

void expectSame(float value, double expected) {
  if (std::isnan(expected)) {
    EXPECT_TRUE(std::isnan(value));
  } else {
    EXPECT_NEAR(value, expected, 2e-2); // heights up to 16777, float sums
  }
}

TEST(Reduce, EqualsTheDefinitionEverywhere) {
  const NodeLattice fine(Scheme(Profile::geodetic), 2, kCells);
  for (const bool voids : {false, true}) {
    for (const auto filter :
         {OverviewResampling::nearest, OverviewResampling::average, OverviewResampling::cubic}) {
      // The whole world at zoom 2: poles and the antimeridian included.
      const NodeWindow window = filledWindow(fine, {0, 0, 7, 3}, haloForLevels(filter, 1), voids);
      NodeWindow coarse;
      coarse.reset(fine.coarser(), {0, 0, 3, 1}, haloForLevels(filter, 0));
      reduceWindow(window, filter, coarse);
      for (int b = 0; b < coarse.height(); ++b) {
        for (int a = 0; a < coarse.width(); ++a) {
          const std::int64_t j = coarse.row0() + b;
          const bool exists = j >= 0 && j <= coarse.lattice().lastRow();
          expectSame(coarse.row(b)[a],
                     exists ? oracle(fine, coarse.column0() + a, j, filter, voids) : NAN);
        }
      }
    }
  }
}

TEST(Reduce, KeepsARampWhereItIs) {
  const NodeLattice fine(Scheme(Profile::geodetic), 5, kCells);
  NodeWindow window;
  window.reset(fine, {8, 8, 9, 9}, 12);
  for (int b = 0; b < window.height(); ++b) {
    for (int a = 0; a < window.width(); ++a) {
      window.row(b)[a] = float(3 * (window.column0() + a) - 2 * (window.row0() + b));
    }
  }
  for (const auto filter :
       {OverviewResampling::nearest, OverviewResampling::average, OverviewResampling::cubic}) {
    NodeWindow coarse;
    coarse.reset(fine.coarser(), {4, 4, 4, 4}, 2);
    reduceWindow(window, filter, coarse);
    for (int b = 0; b < coarse.height(); ++b) {
      for (int a = 0; a < coarse.width(); ++a) {
        EXPECT_EQ(coarse.row(b)[a], float(6 * (coarse.column0() + a) - 4 * (coarse.row0() + b)));
      }
    }
  }
}

TEST(Reduce, SameBitsFromAnyWindow) {
  const NodeLattice fine(Scheme(Profile::geodetic), 3, kCells);
  for (const auto filter : {OverviewResampling::average, OverviewResampling::cubic}) {
    const NodeWindow large = filledWindow(fine, {0, 0, 15, 7}, 12, true);
    const NodeWindow small = filledWindow(fine, {4, 2, 5, 3}, haloForLevels(filter, 1), true);
    NodeWindow fromLarge;
    NodeWindow fromSmall;
    fromLarge.reset(fine.coarser(), {2, 1, 2, 1}, 2);
    fromSmall.reset(fine.coarser(), {2, 1, 2, 1}, 2);
    reduceWindow(large, filter, fromLarge);
    reduceWindow(small, filter, fromSmall);
    const std::size_t bytes = std::size_t(fromLarge.width()) * sizeof(float);
    for (int b = 0; b < fromLarge.height(); ++b) {
      EXPECT_EQ(std::memcmp(fromLarge.row(b), fromSmall.row(b), bytes), 0) << "row " << b;
    }
  }
}

TEST(Reduce, HaloShrinksToWhatTilesNeed) {
  for (const auto filter :
       {OverviewResampling::nearest, OverviewResampling::average, OverviewResampling::cubic}) {
    const int r = reductionRadius(filter);
    EXPECT_GE(haloForLevels(filter, 0), std::max(kTileHalo, r));
    for (int levels = 1; levels <= 3; ++levels) {
      EXPECT_EQ(haloForLevels(filter, levels), 2 * haloForLevels(filter, levels - 1) + r);
    }
  }
}

} // namespace
} // namespace qmesh
