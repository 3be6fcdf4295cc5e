// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "gdalio/crs.h"

#include <cmath>

#include "gdalio/quiet_errors.h"

namespace qmesh {

OGRSpatialReference lonLatSrs() {
  OGRSpatialReference srs;
  srs.importFromEPSG(4326);
  srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return srs;
}

Result<OGRSpatialReference> parseSrs(const std::string& text, const std::string& option) {
  QuietErrors errors;
  OGRSpatialReference srs;
  if (srs.SetFromUserInput(text.c_str()) != OGRERR_NONE)
    return Status(Code::usage, errors.explain("'" + text + "' given with " + option +
                                              " is not a coordinate system; try EPSG:4326"));
  srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return srs;
}

Status makeHorizontal(OGRSpatialReference& srs, const std::string& path) {
  QuietErrors errors;
  if (srs.IsCompound())
    srs.StripVertical();
  if (srs.IsGeographic() && srs.GetAxesCount() == 3)
    srs.DemoteTo2D(nullptr);
  srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (srs.IsGeographic() || srs.IsProjected())
    return {};
  const char* name = srs.GetName();
  return {Code::input, "the coordinate system of '" + path + "' (" + (name ? name : "unnamed") +
                           ") is neither geographic nor projected; give the right one with -s"};
}

bool isLonLatWgs84(const OGRSpatialReference& srs) {
  if (!srs.IsGeographic() || srs.IsDerivedGeographic())
    return false;
  const OGRSpatialReference wgs84 = lonLatSrs();
  const char* const criterion[] = {"CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS",
                                   "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
  return srs.IsSame(&wgs84, criterion) != FALSE;
}

double fullTurn(const OGRSpatialReference& srs) {
  if (!srs.IsGeographic())
    return 0;
  const double turn = 2 * 3.14159265358979323846 / srs.GetAngularUnits();
  return std::abs(turn - 360) < 1e-6 ? 360 : turn;
}

Result<PointTransform> PointTransform::create(const OGRSpatialReference& from,
                                              const OGRSpatialReference& to,
                                              const std::string& path) {
  PointTransform made;
  if (isLonLatWgs84(from) && isLonLatWgs84(to))
    return made;
  QuietErrors errors;
  made.transform_.reset(OGRCreateCoordinateTransformation(&from, &to),
                        OGRCoordinateTransformation::DestroyCT);
  if (!made.transform_)
    return Status(Code::input, errors.explain("no way from the coordinate system of '" + path +
                                              "' to longitude and latitude is known"));
  return made;
}

bool PointTransform::apply(double& x, double& y) const {
  if (!transform_)
    return true;
  int success = FALSE;
  transform_->Transform(1, &x, &y, nullptr, &success);
  return success && std::isfinite(x) && std::isfinite(y);
}

} // namespace qmesh
