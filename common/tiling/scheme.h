// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <string>

#include "base/enum_table.h"

namespace qmesh {

/// The deepest zoom the project makes or reads.
inline constexpr int kMaxZoom = 24;

/// A tile of the pyramid. Rows count from the south (TMS) everywhere in the project; only the
/// edge of the program (file names of --xyz) turns them over.
struct TileId {
  int z = 0;
  std::uint32_t x = 0;
  std::uint32_t y = 0;

  bool operator==(const TileId& o) const { return z == o.z && x == o.x && y == o.y; }
  TileId parent() const { return {z - 1, x / 2, y / 2}; }
};

/// "12/706/2850": zoom, column and row from the south.
std::string tileName(TileId tile);

enum class Profile {
  geodetic, ///< EPSG:4326, two root tiles
  mercator, ///< EPSG:3857, one root tile
};

template <> struct EnumTable<Profile> {
  static constexpr EnumRow<Profile> kRows[] = {
      {Profile::geodetic, "geodetic", "EPSG:4326, two root tiles"},
      {Profile::mercator, "mercator", "EPSG:3857, one root tile"},
  };
};

/// A box in degrees on WGS 84.
struct GeoBox {
  double west = 0;
  double south = 0;
  double east = 0;
  double north = 0;
};

/// The tile matrix set of a profile.
class Scheme {
 public:
  explicit Scheme(Profile profile) : profile_(profile) {}

  Profile profile() const { return profile_; }
  std::uint32_t tilesX(int zoom) const { return (profile_ == Profile::geodetic ? 2u : 1u) << zoom; }
  std::uint32_t tilesY(int zoom) const { return 1u << zoom; }

  /// The tile's square in degrees.
  GeoBox box(TileId tile) const;

  /// Longitude (degrees) of the fraction `numerator / denominator` of the matrix's width from its
  /// west edge; exact for the geodetic profile where the denominator is a power of two.
  double longitude(std::int64_t numerator, std::int64_t denominator) const;
  /// Latitude (degrees) of a fraction of the matrix's height from its south edge.
  double latitude(std::int64_t numerator, std::int64_t denominator) const;
  /// The inverses: the fraction (0..1) of a longitude or latitude in degrees, not clamped.
  double fractionX(double lonDegrees) const;
  double fractionY(double latDegrees) const;

  /// The error CesiumJS takes a level for, metres: R * 2 pi * 0.25 / (65 * roots) / 2^z.
  double geometricError(int zoom) const;

  /// North-south size of a tile at the equator, metres.
  double tileMetres(int zoom) const;

  /// "EPSG:4326" or "EPSG:3857".
  const char* crs() const;

 private:
  Profile profile_;
};

} // namespace qmesh
