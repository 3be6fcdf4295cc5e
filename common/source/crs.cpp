// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/crs.h"

#include <array>
#include <cmath>
#include <memory>

#include "vsi/quiet_errors.h"

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

namespace {

/// A full turn in a cylindrical projection, where x grows evenly with longitude and nothing else
/// does; 0 in any other. Three longitudes on one side of the projection's own cut tell.
double cylindricalTurn(const OGRSpatialReference& srs) {
  QuietErrors errors;
  const std::unique_ptr<OGRSpatialReference, void (*)(OGRSpatialReference*)> base(
      srs.CloneGeogCS(), OGRSpatialReference::DestroySpatialReference);
  if (!base)
    return 0;
  base->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const Result<PointTransform> transform = PointTransform::create(*base, srs, "");
  if (!transform.ok())
    return 0;
  constexpr double kStep = 20; // degrees of most systems; grads and radians only lessen the test
  for (const double first : {10.0, 100.0, -100.0}) {
    std::array<double, 6> x{first, first + kStep, first + 2 * kStep, first, first + kStep, first};
    std::array<double, 6> y{10, 10, 10, 50, 50, -30};
    bool all = true;
    for (std::size_t k = 0; k < x.size(); ++k)
      all = transform->apply(x[k], y[k]) && all;
    const double dx = x[1] - x[0];
    const auto same = [&](double p, double q) { return std::abs(p - q) <= 1e-9 * std::abs(dx); };
    if (all && dx > 0 && same(x[2] - x[1], dx) && same(x[3], x[0]) && same(x[4], x[1]) &&
        same(x[5], x[0]) && same(y[1], y[0]) && same(y[2], y[0]) && same(y[4], y[3]))
      return dx / kStep * (2 * 3.14159265358979323846 / base->GetAngularUnits());
  }
  return 0;
}

} // namespace

double fullTurn(const OGRSpatialReference& srs) {
  if (srs.IsProjected())
    return cylindricalTurn(srs);
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
