// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mesh/check.h"
#include "mesh/error_measure.h"
#include "simplified.h"
#include "simplify/node_mesh.h"
#include "simplify/qem/edge_collapser.h"

namespace qmesh {
namespace {

using namespace test;

std::unique_ptr<Simplifier> qem(const std::string& svo, const std::string& ratio = "") {
  MethodOptions options;
  options.svo = spec(svo);
  options.ratio = spec(ratio);
  return findSimplifier("qem")->create(options);
}

TEST(Qem, KeepsItsPromisesOnEveryTerrainAndPlace) {
  unsigned seed = 1;
  for (const Place& place : places()) {
    for (const Terrain terrain : kTerrains) {
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      for (const double maxError : {40.0, 0.2}) {
        SCOPED_TRACE(testing::Message() << place << " " << name(terrain) << " seed " << seed);
        const Simplified made = simplify(patch.tile(), place.level(maxError), true, "qem");
        ASSERT_EQ(checkTin(made.tin), "");
        EXPECT_EQ(borderPlaces(made), placesOf(made.border));
        EXPECT_EQ(made.tin.reason, StopReason::parameter);
        EXPECT_EQ(measureError(patch.tile(), made.frame, made.tin).max, made.tin.maxError);
      }
    }
  }
}

//  row 8   0 10 20 30 40 30 20 10  0
//   ...    0 10 20 30 40 30 20 10  0   a roof, its ridge along column 4: every inner node can go at
//  row 0   0 10 20 30 40 30 20 10  0   no cost, those of the ridge along the ridge
TEST(Qem, KeepsTheRidgeOfADrawnRoof) {
  const Place place{Profile::geodetic, 14, 9, 9, 8};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (int j = 0; j <= 8; ++j) {
    for (int i = 0; i <= 8; ++i)
      patch.at(i, j) = 40 - 10 * float(std::abs(i - 4));
  }
  LevelParams level = place.level(1);
  level.baseGrid = 1;
  const auto method = qem("0.01");
  const Simplified made = simplify(patch.tile(), level, *method);
  EXPECT_TRUE(innerNodes(made).empty());
  EXPECT_EQ(made.tin.vertices.size(), 6u); // corners and both ends of the ridge
  EXPECT_EQ(made.tin.triangles.size(), 4u);
  EXPECT_LT(made.tin.maxError, 0.01);
}

//  8  .  .  .  .  .  .  .  .  .
//  5  .  . 50  .  .  .  .  .  .     one peak at (2, 5): it stays with the feet of its pyramid, and
//  ...                              no node that is farther away
//  0  .  .  .  .  .  .  .  .  .
TEST(Qem, KeepsADrawnPeakWithItsFeet) {
  const Place place{Profile::geodetic, 14, 9, 9, 8};
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (int j = -2; j <= 10; ++j) {
    for (int i = -2; i <= 10; ++i)
      patch.at(i, j) = i == 2 && j == 5 ? 50 : 0;
  }
  LevelParams level = place.level(1);
  level.baseGrid = 1;
  const auto method = qem("0.01");
  const auto inner = innerNodes(simplify(patch.tile(), level, *method));
  EXPECT_TRUE(inner.count({2, 5}));
  EXPECT_GE(inner.size(), 4u); // three feet around it at least
  for (const auto& [i, j] : inner)
    EXPECT_TRUE(std::abs(i - 2) <= 1 && std::abs(j - 5) <= 1) << i << " " << j;
}

TEST(Qem, FlatTileIsTwoTriangles) {
  const Place place{Profile::geodetic, 15, 1, 1, 256};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  EXPECT_EQ(simplify(patch.tile(), place.level(0.5), true, "qem").tin.triangles.size(), 2u);
}

TEST(Qem, RatioIsTheShareOfVertices) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 64};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 5);
  const auto method = qem("", "0.25");
  const Simplified made = simplify(patch.tile(), place.level(1000), *method);
  EXPECT_EQ(made.tin.vertices.size(), std::size_t(65 * 65 / 4));
  const auto byZoom = qem("", "11:1,12:0.5,13-:1");
  EXPECT_EQ(simplify(patch.tile(), place.level(1000), *byZoom).tin.vertices.size(),
            std::size_t(65 * 65 / 2));
}

TEST(Qem, KeepsTheBaseGrid) {
  const Place place{Profile::geodetic, 0, 0, 0, 64};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  LevelParams level = place.level(20000);
  level.baseGrid = 16;
  const auto inner = innerNodes(simplify(patch.tile(), level, true, "qem"));
  for (int j = 4; j < 64; j += 4) {
    for (int i = 4; i < 64; i += 4)
      EXPECT_TRUE(inner.count({i, j})) << i << " " << j;
  }
  EXPECT_LT(inner.size(), 300u); // a few others sit where no neighbour sees all around them
}

TEST(Qem, LargerObjectsTakeFewerTriangles) {
  const Place place{Profile::geodetic, 12, 1411, 2828, 64};
  const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 5);
  std::size_t last = 64 * 64 * 2 + 1;
  for (const char* svo : {"0.5", "2", "8", "32"}) {
    const auto method = qem(svo);
    const std::size_t now = simplify(patch.tile(), place.level(10), *method).tin.triangles.size();
    EXPECT_LT(now, last) << svo;
    last = now;
  }
}

TEST(Qem, IsAPureFunctionOfTheTile) {
  const auto reused = qem("");
  for (const Place& place : places()) {
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::spikes, 31);
    const LevelParams level = place.level(8);
    const Tin fresh = simplify(patch.tile(), level, true, "qem").tin;
    EXPECT_TRUE(same(fresh, simplify(patch.tile(), level, *reused).tin)) << place;
    EXPECT_TRUE(same(fresh, simplify(patch.tile(), level, *reused).tin)) << place;
  }
}

TEST(Quadric, IsTheSumOfSquaredDistances) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-100, 100);
  const auto vector = [&] {
    const double x = number(random), y = number(random), z = number(random);
    return Vec3{x, y, z};
  };
  Quadric sum, part;
  std::vector<std::pair<Vec3, Vec3>> planes; // a point on it and its normal
  for (int k = 0; k < 20; ++k) {
    planes.push_back({vector(), normalized(vector())});
    const auto& [on, normal] = planes.back();
    (k % 2 ? sum : part).addPlane(normal, -dot(normal, on));
  }
  sum.add(part);
  EXPECT_EQ(sum.planes, 20);
  for (int k = 0; k < 20; ++k) {
    const Vec3 p = vector();
    double expected = 0;
    for (const auto& [on, normal] : planes)
      expected += dot(normal, p - on) * dot(normal, p - on);
    EXPECT_NEAR(sum.at(p), expected, 1e-9 * expected);
  }
}

/// A full mesh about to be collapsed, with its log.
class Collapsing : public testing::Test {
 protected:
  void SetUp() override {
    tile_ = std::make_unique<TerrainPatch>(place_.lattice(), place_.id(), 1, 1, Terrain::ridged, 9);
    const LevelParams level = place_.level(20);
    frame_.reset(tile_->tile(), level);
    makeBorder(tile_->tile(), frame_, level, border_);
    restart();
  }

  void restart() {
    nodes_.resetToAllNodes(tile_->tile(), frame_, border_);
    std::vector<std::uint8_t> stays;
    for (const NodeVertex& v : mesh_.vertices())
      stays.push_back(v.i == 0 || v.j == 0 || v.i == 16 || v.j == 16 ? 1 : 0);
    collapser_.reset(mesh_, {0.01, 0.012}, stays, BaseGrid(), &log_);
  }

  /// Corners of all triangles, each beginning with its smallest; kGone for those collapsed.
  std::vector<std::array<std::int32_t, 3>> triangles() const {
    std::vector<std::array<std::int32_t, 3>> all;
    for (std::int32_t t = 0; t < mesh_.triangleSlots(); ++t) {
      if (mesh_.alive(t))
        all.push_back({mesh_.origin(3 * t), mesh_.origin(3 * t + 1), mesh_.origin(3 * t + 2)});
      else
        all.push_back(DetailCursor::kGone);
    }
    return all;
  }

  const Place place_{Profile::geodetic, 12, 1411, 2828, 16};
  std::unique_ptr<TerrainPatch> tile_;
  TileFrame frame_;
  Border border_;
  NodeMesh nodes_;
  Triangulation& mesh_ = nodes_.triangulation();
  EdgeCollapser collapser_;
  CollapseLog log_;
};

TEST_F(Collapsing, TheLogReplaysEveryState) {
  std::vector<std::vector<std::array<std::int32_t, 3>>> states = {triangles()};
  std::vector<double> svo = {collapser_.svo()};
  while (collapser_.findNext()) {
    collapser_.collapse();
    states.push_back(triangles());
    svo.push_back(collapser_.svo());
  }
  ASSERT_EQ(log_.steps().size() + 1, states.size());
  ASSERT_GT(states.size(), 100u);
  DetailCursor cursor(log_, mesh_);
  EXPECT_EQ(cursor.triangles(), states.back());
  for (std::size_t k = states.size(); k-- > 0;) {
    cursor.moveTo(k);
    EXPECT_EQ(cursor.triangles(), states[k]) << k;
  }
  cursor.moveTo(77);
  EXPECT_EQ(cursor.triangles(), states[77]);
  for (std::size_t k = 0; k < log_.steps().size(); ++k)
    EXPECT_EQ(log_.steps()[k].svo, svo[k + 1]);
}

TEST_F(Collapsing, EveryStateIsAMesh) {
  Tin tin;
  do {
    nodes_.write(tin);
    ASSERT_EQ(checkTin(tin), "") << log_.steps().size();
    EXPECT_EQ(tin.vertices.size(), collapser_.vertices());
    if (collapser_.findNext())
      collapser_.collapse();
  } while (collapser_.findNext());
}

// The oracle keeps the planes themselves.
TEST_F(Collapsing, SvoIsTheRootOfTheMeanLeastQuadricError) {
  struct Plane {
    Vec3 normal, on;
  };
  std::vector<Vec3> points;
  for (const NodeVertex& v : mesh_.vertices())
    points.push_back({v.corner.u * 0.01, v.corner.v * 0.012, v.corner.height});
  std::vector<std::vector<Plane>> planes(points.size());
  for (const auto& [a, b, c] : triangles()) {
    const Vec3 p = points[std::size_t(b)] - points[std::size_t(a)];
    const Vec3 q = points[std::size_t(c)] - points[std::size_t(a)];
    const Vec3 normal =
        normalized({p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x});
    for (const std::int32_t corner : {a, b, c})
      planes[std::size_t(corner)].push_back({normal, points[std::size_t(a)]});
  }
  const auto errorOf = [&](std::size_t v) {
    double sum = 0;
    for (const Plane& plane : planes[v])
      sum += std::pow(dot(plane.normal, points[v] - plane.on), 2);
    return sum;
  };
  for (int k = 0; k < 150; ++k) {
    ASSERT_TRUE(collapser_.findNext());
    const double foretold = collapser_.nextSvo(), error = collapser_.nextError();
    collapser_.collapse();
    const auto v = std::size_t(log_.steps().back().vertex);
    const auto target = std::size_t(log_.steps().back().target);
    planes[target].insert(planes[target].end(), planes[v].begin(), planes[v].end());
    planes[v].clear();
    EXPECT_NEAR(errorOf(target), error, 1e-6 * (1 + error));
    EXPECT_EQ(log_.steps().back().error, error);
    double sum = 0;
    for (std::size_t w = 0; w < points.size(); ++w)
      sum += planes[w].empty() ? 0 : errorOf(w) / double(planes[w].size());
    const double expected = std::sqrt(sum / double(collapser_.vertices()));
    EXPECT_NEAR(collapser_.svo(), expected, 1e-6 * (1 + expected));
    EXPECT_NEAR(foretold, expected, 1e-6 * (1 + expected));
  }
}

TEST_F(Collapsing, StartsWithTheBorderAndEveryInnerNode) {
  Tin tin;
  nodes_.write(tin);
  ASSERT_EQ(checkTin(tin), "");
  std::size_t border = 0;
  for (const auto& places : border_.places)
    border += places.size() - 1;
  EXPECT_EQ(tin.vertices.size(), border + 15 * 15);
}

} // namespace
} // namespace qmesh
