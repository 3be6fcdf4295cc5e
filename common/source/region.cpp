// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qmesh {
namespace {

constexpr double kOutline = 1e-9; ///< degrees that still count as on the outline

/// Longitudes without jumps; a ring that goes round the globe is closed over the nearer pole.
void unwrap(Region::Ring& ring) {
  double meanLatitude = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    meanLatitude += ring[k].lat / double(ring.size());
    if (k > 0)
      ring[k].lon -= 360 * std::floor((ring[k].lon - ring[k - 1].lon) / 360 + 0.5);
  }
  const double turn = 360 * std::floor((ring.back().lon - ring.front().lon) / 360 + 0.5);
  if (turn == 0)
    return;
  const double pole = meanLatitude < 0 ? -90 : 90;
  const Region::Vertex first = ring.front();
  ring.push_back({first.lon + turn, first.lat});
  ring.push_back({first.lon + turn, pole});
  ring.push_back({first.lon, pole});
}

} // namespace

void Region::addPolygon(std::vector<Ring> rings) {
  Polygon polygon;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  polygon.box = {kFar, kFar, -kFar, -kFar};
  double anchor = 0; // the first ring's, which holes must follow
  for (Ring& ring : rings) {
    if (ring.size() < 3)
      continue;
    unwrap(ring);
    double west = kFar;
    for (const Vertex& v : ring)
      west = std::min(west, v.lon);
    const bool outer = polygon.edges.empty();
    const double shift = outer ? -360 * std::floor((west + 180) / 360)
                               : -360 * std::floor((west - anchor) / 360 + kOutline);
    if (outer)
      anchor = west + shift;
    for (Vertex& v : ring) {
      v.lon += shift;
      polygon.box = {std::min(polygon.box.west, v.lon), std::min(polygon.box.south, v.lat),
                     std::max(polygon.box.east, v.lon), std::max(polygon.box.north, v.lat)};
    }
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vertex& a = ring[k];
      const Vertex& b = ring[(k + 1) % ring.size()];
      polygon.edges.push_back(a.lat <= b.lat ? Edge{a, b} : Edge{b, a});
    }
  }
  if (!polygon.edges.empty())
    polygons_.push_back(std::move(polygon));
}

std::vector<GeoBox> Region::boxes() const {
  std::vector<GeoBox> out;
  for (const Polygon& polygon : polygons_) {
    GeoBox box = polygon.box;
    if (box.east - box.west >= 360)
      box.west = -180, box.east = 180;
    out.push_back(box);
  }
  return out;
}

/// The polygon's intervals on a parallel, and on those kOutline above and below: their union holds
/// the outline as well, also where an edge runs along the parallel.
void Region::addSpans(const Polygon& polygon, double latitude, std::vector<Span>& spans) {
  if (latitude < polygon.box.south - kOutline || latitude > polygon.box.north + kOutline)
    return;
  std::vector<double> crossings;
  for (double parallel : {latitude - kOutline, latitude, latitude + kOutline}) {
    crossings.clear();
    for (const Edge& edge : polygon.edges)
      if (edge.a.lat <= parallel && parallel < edge.b.lat)
        crossings.push_back(edge.a.lon + (edge.b.lon - edge.a.lon) *
                                             ((parallel - edge.a.lat) / (edge.b.lat - edge.a.lat)));
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
      spans.push_back({crossings[k] - kOutline, crossings[k + 1] + kOutline});
  }
}

void Region::clearOutside(double latitude, const double* longitudes, int count,
                          float* values) const {
  std::vector<Span> spans;
  for (const Polygon& polygon : polygons_)
    addSpans(polygon, latitude, spans);
  const auto inside = [&](double lon) {
    for (const Span& span : spans)
      for (double turn : {0.0, 360.0})
        if (lon + turn >= span.west && lon + turn <= span.east)
          return true;
    return false;
  };
  for (int k = 0; k < count; ++k)
    if (!inside(longitudes[k]))
      values[k] = std::numeric_limits<float>::quiet_NaN();
}

} // namespace qmesh
