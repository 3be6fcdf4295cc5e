// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/extent.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geo/ellipsoid.h"
#include "source/crs.h"
#include "vsi/quiet_errors.h"

namespace qmesh {
namespace {

constexpr int kOutlinePoints = 100; ///< per side
constexpr int kFewestOutlinePoints = 12;
constexpr int kInnerPoints = 40; ///< per side
constexpr int kFewestInnerPoints = 5;
constexpr std::size_t kManyBoxes = 64;
constexpr double kSnapPixels = 1e-3;
/// Round places: 1/64 arc second, which holds every tile edge down to zoom 12.
constexpr double kRoundPerDegree = 3600 * 64;

struct Place {
  double lon;
  double lat;
};

/// A raster's pixels on the globe and back.
class Placement {
 public:
  Placement(const RasterInput& input, PointTransform toLonLat, PointTransform fromLonLat)
      : frame_(input.frame), toLonLat_(std::move(toLonLat)), fromLonLat_(std::move(fromLonLat)) {}

  std::optional<Place> place(double column, double row) const {
    Place p{};
    frame_.toPlace(column, row, p.lon, p.lat);
    if (!toLonLat_.apply(p.lon, p.lat) || std::abs(p.lat) > 90 + 1e-6)
      return std::nullopt;
    p.lat = std::clamp(p.lat, -90.0, 90.0);
    return p;
  }

  bool holds(double lon, double lat) const {
    if (!fromLonLat_.apply(lon, lat))
      return false;
    double column = 0;
    double row = 0;
    frame_.toPixel(lon, lat, column, row);
    return column >= 0 && column <= frame_.width && row >= 0 && row <= frame_.height;
  }

 private:
  PixelFrame frame_;
  PointTransform toLonLat_, fromLonLat_;
};

Result<Placement> placementOf(const RasterInput& input) {
  Result<PointTransform> out = PointTransform::create(input.srs, lonLatSrs(), input.path);
  if (!out.ok())
    return out.status();
  Result<PointTransform> back = PointTransform::create(lonLatSrs(), input.srs, input.path);
  if (!back.ok())
    return back.status();
  return Placement(input, *std::move(out), *std::move(back));
}

/// West in -180..180; a box that goes round is -180..180.
GeoBox normalised(GeoBox box) {
  if (box.east - box.west >= 360 - 1e-9)
    return {-180, box.south, 180, box.north};
  const double shift = -360 * std::floor((box.west + 180) / 360);
  box.west += shift;
  box.east += shift;
  return box;
}

double snapped(double degrees, double pixelDegrees) {
  const double round = std::round(degrees * kRoundPerDegree) / kRoundPerDegree;
  return std::abs(round - degrees) <= kSnapPixels * pixelDegrees ? round : degrees;
}

GeoBox lonLatExtent(const PixelFrame& frame) {
  GeoBox box{1e9, 1e9, -1e9, -1e9};
  for (double column : {0.0, frame.width})
    for (double row : {0.0, frame.height}) {
      double x = 0;
      double y = 0;
      frame.toPlace(column, row, x, y);
      box = {std::min(box.west, x), std::min(box.south, y), std::max(box.east, x),
             std::max(box.north, y)};
    }
  const double pixelX = std::hypot(frame.toWorld[1], frame.toWorld[2]);
  const double pixelY = std::hypot(frame.toWorld[4], frame.toWorld[5]);
  if (frame.period > 0)
    box.east = box.west + 360;
  box = {snapped(box.west, pixelX), std::max(-90.0, snapped(box.south, pixelY)),
         snapped(box.east, pixelX), std::min(90.0, snapped(box.north, pixelY))};
  return normalised(box);
}

struct Outline {
  std::vector<Place> places;
  bool complete = true; ///< every point has a place
};

Outline outlineOf(const Placement& placement, double width, double height, double share) {
  const int outlinePoints = std::max(kFewestOutlinePoints, int(kOutlinePoints * share));
  const int innerPoints = std::max(kFewestInnerPoints, int(kInnerPoints * share));
  Outline out;
  const auto add = [&](double column, double row) {
    if (const std::optional<Place> p = placement.place(column, row))
      out.places.push_back(*p);
    else
      out.complete = false;
  };
  for (int k = 0; k <= outlinePoints; ++k) {
    const double t = double(k) / outlinePoints;
    add(t * width, 0);
    add(t * width, height);
    add(0, t * height);
    add(width, t * height);
  }
  for (int r = 1; r < innerPoints; ++r)
    for (int c = 1; c < innerPoints; ++c)
      add(c * width / innerPoints, r * height / innerPoints);
  return out;
}

/// The shortest arc of longitudes that holds all places: what the largest gap between neighbours
/// leaves. The whole circle where the raster has data in that gap.
void setLongitudes(std::vector<Place> places, const Placement& placement, GeoBox& box) {
  for (Place& p : places)
    p.lon -= 360 * std::floor((p.lon + 180) / 360);
  std::sort(places.begin(), places.end(), [](auto& a, auto& b) { return a.lon < b.lon; });
  double gap = places.front().lon + 360 - places.back().lon;
  box.west = places.front().lon;
  box.east = places.back().lon;
  for (std::size_t k = 0; k + 1 < places.size(); ++k)
    if (places[k + 1].lon - places[k].lon > gap) {
      gap = places[k + 1].lon - places[k].lon;
      box.west = places[k + 1].lon;
      box.east = places[k].lon + 360;
    }
  for (int k = 0; k <= kOutlinePoints; ++k) {
    const double t = double(k) / kOutlinePoints;
    if (placement.holds(box.east + gap / 2, box.south + t * (box.north - box.south))) {
      box.west = -180;
      box.east = 180;
      return;
    }
  }
}

GeoBox grown(GeoBox box, double fraction) {
  const double dx = fraction * (box.east - box.west);
  const double dy = fraction * (box.north - box.south);
  return normalised({box.west - dx, std::max(-90.0, box.south - dy), box.east + dx,
                     std::min(90.0, box.north + dy)});
}

std::vector<GeoBox> joined(std::vector<GeoBox> boxes) {
  GeoBox all = boxes.front();
  for (const GeoBox& box : boxes)
    all = {std::min(all.west, box.west), std::min(all.south, box.south),
           std::max(all.east, box.east), std::max(all.north, box.north)};
  return {normalised(all)};
}

/// Metres between two places a pixel apart.
double metresBetween(const Place& a, const Place& b) {
  const double lat = (a.lat + b.lat) / 2 * wgs84::kRadiansPerDegree;
  const double e2 =
      1 - (wgs84::kSemiMinor * wgs84::kSemiMinor) / (wgs84::kSemiMajor * wgs84::kSemiMajor);
  const double w2 = 1 - e2 * std::sin(lat) * std::sin(lat);
  const double eastRadius = wgs84::kSemiMajor / std::sqrt(w2);
  const double northRadius = eastRadius * (1 - e2) / w2;
  const double dLon = std::remainder(b.lon - a.lon, 360.0) * wgs84::kRadiansPerDegree;
  const double dLat = (b.lat - a.lat) * wgs84::kRadiansPerDegree;
  return std::hypot(dLon * std::cos(lat) * eastRadius, dLat * northRadius);
}

} // namespace

Result<GeoBox> rasterExtent(const RasterInput& input, double share) {
  if (input.lonLat)
    return lonLatExtent(input.frame);
  QuietErrors errors;
  const Result<Placement> placement = placementOf(input);
  if (!placement.ok())
    return placement.status();
  const Outline outline = outlineOf(*placement, input.frame.width, input.frame.height, share);
  if (outline.places.empty())
    return Status(Code::input, errors.explain("'" + input.path +
                                              "' lies nowhere on the globe: check its coordinate "
                                              "system and geotransform, or give -s"));
  GeoBox box{0, 90, 0, -90};
  for (const Place& p : outline.places) {
    box.south = std::min(box.south, p.lat);
    box.north = std::max(box.north, p.lat);
  }
  setLongitudes(outline.places, *placement, box);
  for (double pole : {-90.0, 90.0})
    if (placement->holds(0, pole)) {
      (pole < 0 ? box.south : box.north) = pole;
      box.west = -180;
      box.east = 180;
    }
  // Where corners have no place the data ends somewhere between two of the inner points.
  return outline.complete
             ? normalised(box)
             : grown(box, 2.0 / std::max(kFewestInnerPoints, int(kInnerPoints * share)));
}

Result<std::vector<GeoBox>> coverageExtent(const RasterInput& input) {
  std::vector<GeoBox> boxes;
  for (const PixelRectangle& r : input.coverage) {
    RasterInput part = input;
    auto transform = input.frame.toWorld;
    input.frame.toPlace(r.column, r.row, transform[0], transform[3]);
    part.frame.set(transform, r.width, r.height, input.frame.turn);
    const double share = std::max(r.width / input.frame.width, r.height / input.frame.height);
    const Result<GeoBox> box = rasterExtent(part, share);
    if (box.ok())
      boxes.push_back(*box);
    else if (input.coverage.size() == 1)
      return box.status();
  }
  return boxes;
}

GeoBox widened(const GeoBox& box) {
  return grown(box, 0.02);
}

std::vector<GeoBox> cropped(const std::vector<GeoBox>& boxes, const Region& region) {
  if (region.empty())
    return boxes;
  std::vector<GeoBox> parts = region.boxes();
  if (parts.size() > kManyBoxes)
    parts = joined(std::move(parts));
  std::vector<GeoBox> out;
  for (const GeoBox& a : boxes)
    for (const GeoBox& b : parts)
      for (double turn : {-360.0, 0.0, 360.0}) {
        const GeoBox common{std::max(a.west, b.west + turn), std::max(a.south, b.south),
                            std::min(a.east, b.east + turn), std::min(a.north, b.north)};
        if (common.west < common.east && common.south < common.north)
          out.push_back(normalised(common));
      }
  return out;
}

int nativeZoomOf(const RasterInput& input, const Scheme& scheme, int cellsPerTile) {
  QuietErrors errors;
  const Result<Placement> placement = placementOf(input);
  if (!placement.ok())
    return 0;
  const double column = input.frame.width / 2;
  const double row = input.frame.height / 2;
  const auto at = [&](double c, double r) { return placement->place(column + c, row + r); };
  const std::optional<Place> west = at(-0.5, 0), east = at(0.5, 0), north = at(0, -0.5),
                             south = at(0, 0.5), centre = at(0, 0);
  if (!west || !east || !north || !south || !centre)
    return 0;
  const bool geodetic = scheme.profile() == Profile::geodetic;
  const auto& g = input.frame.toWorld;
  const bool degrees = geodetic && input.srs.IsGeographic();
  const double unit = degrees ? 360 / input.frame.turn : 1;
  const double cell = degrees
                          ? unit * std::min(std::hypot(g[1], g[4]), std::hypot(g[2], g[5]))
                          : std::min(metresBetween(*west, *east), metresBetween(*north, *south));
  // The mercator square ends before the poles, and so does the stretch of its nodes.
  const double edge = geodetic ? 90 : scheme.latitude(1, 1);
  const Place middle{centre->lon, std::clamp(centre->lat, -edge, edge)};
  for (int zoom = 0; zoom < kMaxZoom; ++zoom) {
    const double spacing = 360.0 / double(std::int64_t(scheme.tilesX(zoom)) * cellsPerTile);
    const double dLat =
        geodetic ? spacing : spacing * std::cos(middle.lat * wgs84::kRadiansPerDegree);
    const double northward =
        metresBetween({middle.lon, middle.lat - dLat / 2}, {middle.lon, middle.lat + dLat / 2});
    const double eastward = metresBetween(middle, {middle.lon + spacing, middle.lat});
    const double metres = geodetic ? northward : std::min(northward, eastward);
    if ((degrees ? spacing : metres) <= cell * (1 + 1e-4))
      return zoom;
  }
  return kMaxZoom;
}

} // namespace qmesh
