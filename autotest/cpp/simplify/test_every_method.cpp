// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// What every method of the registry promises, with its defaults: a new row is tested by being
// there.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "mesh/check.h"
#include "mesh/error_measure.h"
#include "seam.h"

namespace qmesh {
namespace {

using namespace test;

constexpr Edge kEdges[] = {kWest, kSouth, kEast, kNorth};

/// Max errors that leave a few vertices, and many, for a place's size.
std::vector<double> maxErrors(const Place& place) {
  const double cell = place.lattice().scheme().tileMetres(place.zoom) / place.cells;
  return {std::max(0.02, cell / 2), std::max(0.01, cell / 30)};
}

/// Small tiles of both profiles, of 1 m and of 1000 km, at poles and at the ends of the lattice.
std::vector<Place> smallPlaces() {
  using P = Profile;
  return {{P::geodetic, 0, 1, 0, 16},
          {P::geodetic, 1, 3, 1, 8},
          {P::geodetic, 4, 31, 15, 8},
          {P::geodetic, 4, 3, 8, 16},
          {P::geodetic, 13, 5000, 6000, 8},
          {P::geodetic, 24, 20000001, 12000000, 8},
          {P::geodetic, 24, 20000001, 9000000, 16},
          {P::mercator, 0, 0, 0, 16},
          {P::mercator, 5, 31, 31, 8},
          {P::mercator, 12, 100, 1500, 16}};
}

std::vector<Place> largePlaces() {
  using P = Profile;
  return {{P::geodetic, 2, 7, 3, 64},
          {P::geodetic, 13, 5000, 6000, 64},
          {P::mercator, 14, 77, 12000, 64}};
}

class EveryMethod : public testing::TestWithParam<const SimplifierInfo*> {
 protected:
  std::unique_ptr<Simplifier> create() const { return GetParam()->create(MethodOptions()); }

  Simplified make(const HeightTile& tile, const LevelParams& level) const {
    return simplify(tile, level, *create());
  }
};

/// The vertices at the nodes of the base grid, corners included.
std::size_t curvatureNodes(const Simplified& made) {
  std::set<std::pair<int, int>> places;
  for (const TinVertex& vertex : made.tin.vertices)
    places.insert({vertex.u, vertex.v});
  const int n = made.frame.cells(), step = n / made.level.baseGrid;
  std::size_t count = 0;
  for (int j = 0; j <= n; j += step) {
    for (int i = 0; i <= n; i += step)
      count += places.count({made.frame.u(i), made.frame.v(j)});
  }
  return count;
}

/// Each vertex of an edge has the height that the tile next door computes for it.
void expectContractHeights(const HeightTile& tile, const Simplified& made) {
  for (const TinVertex& vertex : made.tin.vertices) {
    const int i = made.frame.nearestColumn(vertex.u), j = made.frame.nearestRow(vertex.v);
    const bool onEdge =
        vertex.u == 0 || vertex.v == 0 || vertex.u == kQuantizedMax || vertex.v == kQuantizedMax;
    if (onEdge) {
      EXPECT_EQ(vertex.q, made.frame.quantizeBorder(tile.at(i, j))) << i << " " << j;
    }
  }
}

/// The longest edge of a TIN, squared, and that of the diagonals of its base grid's cells.
std::int64_t longestEdge(const Tin& tin) {
  std::int64_t longest = 0;
  for (const TinTriangle& t : tin.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const TinVertex &a = tin.vertices[t[k]], &b = tin.vertices[t[(k + 1) % 3]];
      const std::int64_t u = a.u - b.u, v = a.v - b.v;
      longest = std::max(longest, u * u + v * v);
    }
  }
  return longest;
}

std::int64_t longestDiagonal(const Simplified& made) {
  const int n = made.frame.cells(), step = n / made.level.baseGrid;
  std::int64_t longest = 0;
  for (int j = 0; j < n; j += step) {
    for (int i = 0; i < n; i += step) {
      const std::int64_t u = made.frame.u(i + step) - made.frame.u(i);
      const std::int64_t v = made.frame.v(j + step) - made.frame.v(j);
      longest = std::max(longest, u * u + v * v);
    }
  }
  return longest;
}

/// P2, where rounding does not forbid it: then a mesh of all nodes misses the max error as well, or
/// heights cannot be rounded finely enough.
void expectBounded(const HeightTile& tile, const Simplified& made) {
  if (made.tin.reason != StopReason::quantization) {
    EXPECT_LE(made.tin.maxError, made.level.maxError);
    return;
  }
  const Simplified all = simplify(tile, made.level, true, "delaunay");
  EXPECT_TRUE(all.tin.maxError > 0.8 * made.level.maxError ||
              made.level.maxError < 1.1 * made.level.borderRounding() ||
              made.level.maxError < made.frame.heightStep() || made.frame.coarseStep() > 0)
      << "reached " << made.tin.maxError << " of " << made.level.maxError;
}

void expectPromises(const HeightTile& tile, const Simplified& made, bool boundsError) {
  ASSERT_EQ(checkTin(made.tin), "");
  EXPECT_EQ(borderPlaces(made), placesOf(made.border));
  const std::size_t grid = std::size_t(made.level.baseGrid) + 1;
  EXPECT_EQ(curvatureNodes(made), grid * grid);
  EXPECT_LE(longestEdge(made.tin), longestDiagonal(made));
  expectContractHeights(tile, made);
  const ErrorMeasure measure = measureError(tile, made.frame, made.tin);
  EXPECT_EQ(made.tin.maxError, measure.max);
  EXPECT_EQ(made.tin.sumSquaredError, measure.sumSquared);
  if (boundsError)
    expectBounded(tile, made);
}

TEST_P(EveryMethod, KeepsItsPromisesOnEveryTerrain) {
  unsigned seed = 500;
  for (const Place& place : smallPlaces()) {
    for (const Terrain terrain : kTerrains) {
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      for (const double maxError : maxErrors(place)) {
        SCOPED_TRACE(testing::Message()
                     << place << " " << name(terrain) << " seed " << seed << " " << maxError);
        expectPromises(patch.tile(), make(patch.tile(), place.level(maxError)),
                       GetParam()->boundsError);
      }
    }
  }
}

TEST_P(EveryMethod, KeepsItsPromisesOnLargeTiles) {
  unsigned seed = 900;
  for (const Place& place : largePlaces()) {
    for (const Terrain terrain : {Terrain::fractal, Terrain::ridged, Terrain::cliff}) {
      SCOPED_TRACE(testing::Message() << place << " " << name(terrain));
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      expectPromises(patch.tile(), make(patch.tile(), place.level(maxErrors(place)[0])),
                     GetParam()->boundsError);
    }
  }
}

/// Where the globe is curved no edge is longer than the diagonal of a cell of the base grid,
/// however little the heights need: at the max errors of the zooms by default.
TEST_P(EveryMethod, KeepsEdgesShortOnTheGlobe) {
  using P = Profile;
  unsigned seed = 1700;
  for (const Place& place : {Place{P::geodetic, 0, 1, 0, 64}, Place{P::geodetic, 3, 5, 6, 64},
                             Place{P::geodetic, 5, 16, 22, 64}, Place{P::geodetic, 7, 50, 90, 32},
                             Place{P::geodetic, 9, 270, 360, 64}, Place{P::mercator, 0, 0, 0, 64},
                             Place{P::mercator, 1, 1, 1, 64}, Place{P::mercator, 6, 20, 40, 64}}) {
    const double maxError = place.profile == P::geodetic ? 19267 : 38533;
    const LevelParams level = place.level(maxError / (1 << place.zoom));
    ASSERT_GT(level.baseGrid, 1);
    for (const Terrain terrain : {Terrain::flat, Terrain::plane, Terrain::fractal, Terrain::ridged,
                                  Terrain::steps, Terrain::extreme}) {
      SCOPED_TRACE(testing::Message() << place << " " << name(terrain) << " seed " << seed + 1);
      const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, ++seed);
      const Simplified made = make(patch.tile(), level);
      EXPECT_LE(longestEdge(made.tin), longestDiagonal(made));
    }
  }
}

/// Terrain of one formula on the tile and its halo.
TerrainPatch formula(const Place& place, const std::function<double(int, int)>& height) {
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::flat, 1);
  for (int j = -kTileHalo; j <= place.cells + kTileHalo; ++j) {
    for (int i = -kTileHalo; i <= place.cells + kTileHalo; ++i)
      patch.at(i, j) = float(height(i, j));
  }
  return patch;
}

TEST_P(EveryMethod, TakesDegenerateTerrain) {
  const struct {
    const char* name;
    std::function<double(int, int)> height;
  } kinds[] = {
      {"sea level", [](int, int) { return 0; }},
      {"spike", [](int i, int j) { return i == 5 && j == 3 ? 3000 : 0; }},
      {"spike at the edge", [](int i, int j) { return i == 0 && j == 3 ? 3000 : 0; }},
      {"spike at a corner", [](int i, int j) { return i == 0 && j == 0 ? -3000 : 0; }},
      {"step", [](int i, int) { return i >= 4 ? 100 : 0; }},
      {"stair of one cell", [](int i, int j) { return i >= 4 && i < 5 && j < 4 ? 100 : 0; }},
      {"plane", [](int i, int j) { return 10 * i + 10 * j; }},
      {"highest and lowest", [](int i, int j) { return (i * 7 + j * 3) % 5 ? 9000 : -11000; }},
  };
  for (const Place& place :
       {Place{Profile::geodetic, 4, 20, 7, 8}, Place{Profile::geodetic, 24, 20000001, 12000000, 8},
        Place{Profile::mercator, 10, 300, 400, 16}}) {
    for (const auto& kind : kinds) {
      for (const double maxError : maxErrors(place)) {
        SCOPED_TRACE(testing::Message() << place << " " << kind.name << " " << maxError);
        const TerrainPatch patch = formula(place, kind.height);
        expectPromises(patch.tile(), make(patch.tile(), place.level(maxError)),
                       GetParam()->boundsError);
      }
    }
  }
}

TEST_P(EveryMethod, LeavesNoSeam) {
  using P = Profile;
  unsigned seed = 1300;
  // Inner tiles, the antimeridian (the last x) and the rows at the poles.
  for (const Place& place :
       {Place{P::geodetic, 3, 15, 4, 32}, Place{P::geodetic, 0, 1, 0, 16},
        Place{P::geodetic, 11, 100, 2046, 16}, Place{P::geodetic, 4, 31, 0, 16},
        Place{P::mercator, 2, 3, 1, 32}, Place{P::mercator, 0, 0, 0, 16}}) {
    for (const Terrain terrain : {Terrain::fractal, Terrain::spikes, Terrain::steps,
                                  Terrain::checkerboard, Terrain::extreme, Terrain::plane}) {
      SCOPED_TRACE(testing::Message() << place << " " << name(terrain) << " seed " << seed + 1);
      const bool twoRows = place.y + 1 < place.lattice().scheme().tilesY(place.zoom);
      const TerrainPatch patch(place.lattice(), place.id(), 2, twoRows ? 2 : 1, terrain, ++seed);
      const LevelParams level = place.level(maxErrors(place)[0]);
      const HeightTile here = patch.tile(0, 0), east = patch.tile(1, 0);
      const Simplified madeHere = make(here, level);
      expectSeamless(seam(here, madeHere, kEast), seam(east, make(east, level), kWest));
      if (twoRows) {
        const HeightTile north = patch.tile(0, 1);
        expectSeamless(seam(here, madeHere, kNorth), seam(north, make(north, level), kSouth));
      }
    }
  }
}

TEST_P(EveryMethod, APoleHasOneHeight) {
  for (const std::uint32_t y : {0u, 3u}) {
    const Place place{Profile::geodetic, 2, 5, y, 32};
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 8);
    const HeightTile tile = patch.tile();
    const auto pole = seam(tile, make(tile, place.level(50)), y == 0 ? kSouth : kNorth);
    for (const auto& [position, vertex] : pole)
      EXPECT_EQ(vertex.height, pole.begin()->second.height) << position;
  }
}

/// An edge is a function of its nodes and the two to both sides: other terrain beyond them, and
/// beyond the edge's ends, changes nothing.
TEST_P(EveryMethod, AnEdgeSeesNothingBeyondTwoNodes) {
  const Place place{Profile::geodetic, 9, 700, 300, 32};
  const LevelParams level = place.level(maxErrors(place)[0]);
  TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::ridged, 41);
  const TerrainPatch other(place.lattice(), place.id(), 1, 1, Terrain::spikes, 42);
  const auto simplifier = create();
  TileFrame frame;
  Border before, after;
  frame.reset(patch.tile(), level);
  simplifier->makeBorder(patch.tile(), frame, level, before);
  const int n = place.cells;
  for (int j = -kTileHalo; j <= n + kTileHalo; ++j) {
    for (int i = kTileHalo + 1; i <= n + kTileHalo; ++i)
      patch.at(i, j) = other.tile().at(i, j);
  }
  frame.reset(patch.tile(), level);
  simplifier->makeBorder(patch.tile(), frame, level, after);
  EXPECT_EQ(before[kWest], after[kWest]);
}

TEST_P(EveryMethod, IsAPureFunction) {
  const auto used = create();
  for (const Place& place :
       {Place{Profile::geodetic, 4, 20, 7, 16}, Place{Profile::mercator, 12, 1000, 1500, 64}}) {
    const LevelParams level = place.level(maxErrors(place)[0]);
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 17);
    const TerrainPatch other(place.lattice(), place.id(), 1, 1, Terrain::spikes, 18);
    const Simplified first = simplify(patch.tile(), level, *used);
    simplify(other.tile(), place.level(level.maxError * 3), *used);
    EXPECT_TRUE(same(first.tin, simplify(patch.tile(), level, *used).tin)) << "a used instance";
    EXPECT_TRUE(same(first.tin, make(patch.tile(), level).tin)) << "a new instance";
  }
}

/// Frees the edges whose bit is set; they begin with the nodes of the base grid.
void freeEdges(unsigned bits, Simplified& made) {
  for (const Edge edge : kEdges) {
    if ((bits >> edge & 1) == 0)
      continue;
    const int n = made.frame.cells();
    made.border.isFree[edge] = true;
    made.border[edge].clear();
    for (int k = 0; k <= n; k += n / made.level.baseGrid)
      made.border[edge].push_back(edge % 2 ? made.frame.u(k) : made.frame.v(k));
  }
}

void expectBorderKept(const HeightTile& tile, const Simplified& made) {
  for (const Edge edge : kEdges) {
    std::vector<std::uint16_t> reached;
    for (const auto& vertex : seam(tile, made, edge))
      reached.push_back(std::uint16_t(vertex.first));
    const std::vector<std::uint16_t>& asked = made.border[edge];
    if (made.border.isFree[edge])
      EXPECT_TRUE(std::includes(reached.begin(), reached.end(), asked.begin(), asked.end()));
    else
      EXPECT_EQ(reached, asked);
  }
}

/// --border inherit: final edges stay as they are, free ones keep what they have and may get more.
TEST_P(EveryMethod, KeepsFinalEdgesAndAddsToFreeOnes) {
  const Place place{Profile::geodetic, 9, 700, 300, 32};
  const auto simplifier = create();
  const unsigned masks = simplifier->choosesBorder() ? 16 : 1; // else the caller makes its edges
  for (const Terrain terrain : kTerrains) {
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, terrain, 61);
    const HeightTile tile = patch.tile();
    for (unsigned mask = 0; mask < masks; ++mask) {
      SCOPED_TRACE(testing::Message() << name(terrain) << " free edges " << mask);
      Simplified made;
      made.level = place.level(maxErrors(place)[0]);
      made.frame.reset(tile, made.level);
      simplifier->makeBorder(tile, made.frame, made.level, made.border);
      freeEdges(mask, made);
      ASSERT_TRUE(simplifier->simplify(tile, made.frame, made.border, made.level, made.tin).ok());
      ASSERT_EQ(checkTin(made.tin), "");
      expectContractHeights(tile, made);
      expectBorderKept(tile, made);
      if (GetParam()->boundsError)
        expectBounded(tile, made);
    }
  }
}

TEST_P(EveryMethod, SaysWhatItIs) {
  const SimplifierInfo& info = *GetParam();
  EXPECT_NE(std::string(info.sentence), "");
}

std::vector<const SimplifierInfo*> allMethods() {
  std::vector<const SimplifierInfo*> all;
  for (const SimplifierInfo& info : simplifiers())
    all.push_back(&info);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryMethod, testing::ValuesIn(allMethods()),
                         [](const auto& method) { return std::string(method.param->name); });

} // namespace
} // namespace qmesh
