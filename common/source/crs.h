// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <string>

#include <ogr_spatialref.h>

#include "base/status.h"

/// Coordinate systems, always with longitude or easting first.
namespace qmesh {

/// WGS 84 longitude and latitude in degrees: the coordinates of nodes.
OGRSpatialReference lonLatSrs();

/// A coordinate system from anything GDAL understands ("EPSG:32611", WKT, a PROJ text, a file).
/// Code::usage naming `option` where it is none.
Result<OGRSpatialReference> parseSrs(const std::string& text, const std::string& option);

/// Drops the vertical part and puts the axes in order. Code::input naming `path` where what is left
/// is neither geographic nor projected.
Status makeHorizontal(OGRSpatialReference& srs, const std::string& path);

/// True where longitude and latitude of `srs` are those of WGS 84: no PROJ needed.
bool isLonLatWgs84(const OGRSpatialReference& srs);

/// A full turn of longitude in the units of `srs`: 360 for degrees, the width of the world in a
/// cylindrical projection, 0 in one where x does not go round.
double fullTurn(const OGRSpatialReference& srs);

/// Moves single points between two systems. PROJ may choose between several operations, by the
/// place of the points it gets in one call: one point a call makes the result a pure function of
/// the point. Serves one thread.
class PointTransform {
 public:
  /// Code::input naming `path` where there is no way between the two.
  static Result<PointTransform> create(const OGRSpatialReference& from,
                                       const OGRSpatialReference& to, const std::string& path);

  /// False where the point has no image.
  bool apply(double& x, double& y) const;

 private:
  std::shared_ptr<OGRCoordinateTransformation> transform_; ///< null: nothing to do
};

} // namespace qmesh
