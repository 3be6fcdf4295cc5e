// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// Promise P1 through all of mesh, border and simplify: neighbours cut from one field.
#include <gtest/gtest.h>

#include "seam.h"

namespace qmesh {
namespace {

using namespace test;

TEST(Seams, NeighboursAgree) {
  using P = Profile;
  const Terrain kinds[] = {Terrain::fractal, Terrain::ridged, Terrain::spikes,
                           Terrain::plane,   Terrain::steps,  Terrain::checkerboard,
                           Terrain::flat,    Terrain::extreme};
  unsigned seed = 100;
  // Inner tiles, the antimeridian (the last x) and the rows at the poles.
  for (const Place& place :
       {Place{P::geodetic, 3, 15, 4, 64}, Place{P::geodetic, 0, 1, 0, 16},
        Place{P::geodetic, 11, 100, 2046, 32}, Place{P::geodetic, 4, 31, 0, 32},
        Place{P::mercator, 2, 3, 1, 128}, Place{P::mercator, 14, 77, 12000, 256},
        Place{P::mercator, 0, 0, 0, 64}}) {
    for (const Terrain terrain : kinds) {
      for (const double maxError : {100.0, 5.0}) {
        SCOPED_TRACE(testing::Message()
                     << place << " " << name(terrain) << " seed " << seed << " " << maxError);
        const bool twoRows = place.y + 1 < place.lattice().scheme().tilesY(place.zoom);
        const TerrainPatch patch(place.lattice(), place.id(), 2, twoRows ? 2 : 1, terrain, ++seed);
        const LevelParams level = place.level(maxError);
        const HeightTile hereTile = patch.tile(0, 0), eastTile = patch.tile(1, 0);
        const Simplified here = simplify(hereTile, level), east = simplify(eastTile, level);
        expectSeamless(seam(hereTile, here, kEast), seam(eastTile, east, kWest));
        if (twoRows) {
          const HeightTile northTile = patch.tile(0, 1);
          const Simplified north = simplify(northTile, level);
          expectSeamless(seam(hereTile, here, kNorth), seam(northTile, north, kSouth));
        }
      }
    }
  }
}

TEST(Seams, APoleHasOneHeight) {
  for (const std::uint32_t y : {0u, 3u}) {
    const Place place{Profile::geodetic, 2, 5, y, 64};
    const TerrainPatch patch(place.lattice(), place.id(), 1, 1, Terrain::fractal, 8);
    const Simplified made = simplify(patch.tile(), place.level(50));
    const auto pole = seam(patch.tile(), made, y == 0 ? kSouth : kNorth);
    for (const auto& [position, vertex] : pole)
      EXPECT_EQ(vertex.height, pole.begin()->second.height) << position;
  }
}

} // namespace
} // namespace qmesh
