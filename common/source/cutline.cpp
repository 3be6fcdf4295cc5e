// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/cutline.h"

#include <cmath>
#include <memory>

#include <gdal_priv.h>
#include <ogr_geometry.h>
#include <ogrsf_frmts.h>

#include "source/crs.h"
#include "vsi/quiet_errors.h"

namespace qmesh {
namespace {

/// Straight lines of another system are curves in longitude and latitude: they are cut in so many
/// pieces per side of the polygon's box.
constexpr int kPiecesPerSide = 512;
/// Degrees: steps of less than half a turn leave no doubt about the way round.
constexpr double kUnambiguousStep = 90;

/// The ring in degrees; false where a vertex has no place.
bool toLonLat(const OGRLineString& line, const PointTransform& transform, Region::Ring& ring) {
  const int count = line.getNumPoints() - (line.get_IsClosed() ? 1 : 0);
  for (int k = 0; k < count; ++k) {
    Region::Vertex v{line.getX(k), line.getY(k)};
    if (!transform.apply(v.lon, v.lat))
      return false;
    ring.push_back(v);
  }
  return true;
}

bool addPolygon(OGRPolygon& polygon, const PointTransform& transform, bool straight,
                Region& region) {
  if (polygon.IsEmpty())
    return true;
  OGREnvelope box;
  polygon.getEnvelope(&box);
  const double side = std::fmax(box.MaxX - box.MinX, box.MaxY - box.MinY);
  if (straight)
    polygon.segmentize(kUnambiguousStep);
  else if (side > 0)
    polygon.segmentize(side / kPiecesPerSide);
  std::vector<Region::Ring> rings;
  for (OGRLinearRing* line : polygon) {
    rings.emplace_back();
    if (!toLonLat(*line, transform, rings.back()))
      return false;
  }
  region.addPolygon(std::move(rings));
  return true;
}

bool addGeometry(const OGRGeometry& any, const PointTransform& transform, bool straight,
                 Region& region) {
  const std::unique_ptr<OGRGeometry> geometry(any.getLinearGeometry());
  const OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
  if (type == wkbPolygon || type == wkbTriangle)
    return addPolygon(*geometry->toPolygon(), transform, straight, region);
  if (!OGR_GT_IsSubClassOf(type, wkbGeometryCollection))
    return true;
  for (const OGRGeometry* part : *geometry->toGeometryCollection())
    if (!addGeometry(*part, transform, straight, region))
      return false;
  return true;
}

Status addLayer(OGRLayer& layer, const std::string& path, const OGRSpatialReference& rasterSrs,
                Region& region) {
  OGRSpatialReference srs = rasterSrs;
  if (const OGRSpatialReference* own = layer.GetSpatialRef()) {
    srs = *own;
    QMESH_RETURN_IF_ERROR(makeHorizontal(srs, path));
  }
  const Result<PointTransform> transform = PointTransform::create(srs, lonLatSrs(), path);
  if (!transform.ok())
    return transform.status();
  for (const OGRFeatureUniquePtr& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    if (geometry && !addGeometry(*geometry, *transform, isLonLatWgs84(srs), region))
      return {Code::input, "a polygon of the cutline '" + path +
                               "' cannot be moved to longitude and latitude; give the cutline in "
                               "EPSG:4326"};
  }
  return {};
}

} // namespace

Result<Region> readCutline(const std::string& path, const OGRSpatialReference& rasterSrs) {
  QuietErrors errors;
  const GDALDatasetUniquePtr dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
  if (!dataset)
    return Status(Code::input, errors.explain("the cutline '" + path +
                                              "' cannot be opened as a vector dataset"));
  Region region;
  for (OGRLayer* layer : dataset->GetLayers())
    QMESH_RETURN_IF_ERROR(addLayer(*layer, path, rasterSrs, region));
  if (region.empty())
    return Status(Code::input, errors.explain("the cutline '" + path + "' has no polygon"));
  return region;
}

Result<Region> readExtent(const InputOptions& options, const OGRSpatialReference& rasterSrs) {
  const auto& [west, south, east, north] = *options.extent;
  if (!(west < east && south < north && std::isfinite(west + south + east + north)))
    return Status(Code::usage, "--te wants XMIN YMIN XMAX YMAX with XMIN < XMAX and YMIN < YMAX");
  OGRSpatialReference srs = rasterSrs;
  if (!options.extentSrs.empty()) {
    Result<OGRSpatialReference> given = parseSrs(options.extentSrs, "--te-srs");
    if (!given.ok())
      return given.status();
    srs = *given;
    QMESH_RETURN_IF_ERROR(makeHorizontal(srs, "--te-srs"));
  }
  const Result<PointTransform> transform = PointTransform::create(srs, lonLatSrs(), "--te-srs");
  if (!transform.ok())
    return transform.status();
  OGRLinearRing ring;
  for (const auto& [x, y] : {std::pair{west, south}, {east, south}, {east, north}, {west, north}})
    ring.addPoint(x, y);
  ring.closeRings();
  ring.segmentize(std::fmax(east - west, north - south) / kPiecesPerSide);
  Region::Ring vertices;
  if (!toLonLat(ring, *transform, vertices))
    return Status(Code::input,
                  "the rectangle of --te has corners that are nowhere on the globe; give "
                  "it in degrees with --te-srs EPSG:4326");
  Region region;
  region.addPolygon({std::move(vertices)});
  return region;
}

} // namespace qmesh
