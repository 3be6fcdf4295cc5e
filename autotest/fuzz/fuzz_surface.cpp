// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <cmath>

#include "codec/decode.h"
#include "require.h"
#include "surface/surface_raster.h"
#include "surface/surface_search.h"

/// Any bytes that decode: the surface has heights within the tile's own or none, in rasters of both
/// registrations, of the tile and of a part of it, and at places.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace qmesh;
  const auto mesh = decodeTile(data, size);
  if (!mesh.ok())
    return 0;
  const double low = std::min(mesh->header.minHeight, mesh->header.maxHeight);
  const double high = std::max(mesh->header.minHeight, mesh->header.maxHeight);
  const double largest = std::max(std::abs(low), std::abs(high)); // a header may hold 1e38 metres
  const double slack = 1e-3 * (high - low) + 2e-7 * largest + 1e-3;
  const TileId part{9, 17, 40}, tile{3, 0, 0};
  for (const Profile profile : {Profile::geodetic, Profile::mercator})
    for (const Registration registration : {Registration::cell, Registration::node})
      for (const TilePlaces& places : {TilePlaces(Scheme(profile), tile, 16, registration),
                                       TilePlaces(Scheme(profile), part, tile, 16, registration)})
        for (const double height : rasterHeights(*mesh, places))
          fuzz::require(std::isnan(height) || (height >= low - slack && height <= high + slack),
                        "heights of a raster within those of the tile");
  const SurfaceSearch search(*mesh);
  for (double place = 0; place < 32768; place += 997)
    if (const auto height = search.heightAt(place, 32767 - place / 2))
      fuzz::require(*height >= low - slack && *height <= high + slack,
                    "a height within those of the tile");
  return 0;
}
