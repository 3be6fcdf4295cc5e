// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/finish.h"
#include "simplify/full_grid.h"
#include "simplify/methods.h"

namespace qmesh {

namespace {

/// The grid of all nodes, each cell cut along the diagonal whose ends differ less in height.
class AllNodes final : public Simplifier {
 public:
  void makeBorder(const HeightTile& tile, const TileFrame& frame, const LevelParams&,
                  Border& border) const override {
    for (int edge = 0; edge < 4; ++edge) {
      border.places[std::size_t(edge)].clear();
      for (int k = 0; k <= tile.cells(); ++k)
        border.places[std::size_t(edge)].push_back(edge % 2 == 0 ? frame.v(k) : frame.u(k));
    }
  }

  Status simplify(const HeightTile& tile, const TileFrame& frame, const Border&,
                  const LevelParams& level, Tin& out) override {
    out.clear();
    addVertices(tile, frame, out);
    addTriangles(tile, out);
    finishTin(tile, frame, level, StopReason::allNodes, out);
    return {};
  }

 private:
  static void addVertices(const HeightTile& tile, const TileFrame& frame, Tin& out) {
    const int n = tile.cells();
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        const bool border = i == 0 || j == 0 || i == n || j == n;
        const float height = tile.at(i, j);
        out.vertices.push_back({frame.u(i), frame.v(j),
                                border ? frame.quantizeBorder(height) : frame.quantize(height)});
      }
    }
  }

  static void addTriangles(const HeightTile& tile, Tin& out) {
    const int n = tile.cells();
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const auto sw = std::uint32_t(j * (n + 1) + i);
        const std::uint32_t se = sw + 1, nw = sw + std::uint32_t(n) + 1, ne = nw + 1;
        if (cutsRising(tile, i, j)) {
          out.triangles.push_back({sw, se, ne});
          out.triangles.push_back({sw, ne, nw});
        } else {
          out.triangles.push_back({sw, se, nw});
          out.triangles.push_back({se, ne, nw});
        }
      }
    }
  }
};

} // namespace

std::unique_ptr<Simplifier> createAllNodes(const MethodOptions&) {
  return std::make_unique<AllNodes>();
}

} // namespace qmesh
