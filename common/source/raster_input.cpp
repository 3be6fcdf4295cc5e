// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/raster_input.h"

#include <algorithm>

#include <cpl_minixml.h>
#include <cpl_string.h>

#include "source/crs.h"
#include "vsi/quiet_errors.h"

namespace qmesh {
namespace {

Status bad(const std::string& path, const std::string& fault) {
  return {Code::input, "'" + path + "' " + fault};
}

Status checkFormats(const std::vector<std::string>& formats) {
  for (const std::string& name : formats)
    if (!GetGDALDriverManager()->GetDriverByName(name.c_str()))
      return {Code::usage,
              "--if " + name + ": GDAL has no such driver here; gdalinfo --formats lists them"};
  return {};
}

bool hasOpenOption(const CPLXMLNode* list, const std::string& name) {
  for (const CPLXMLNode* node = list->psChild; node; node = node->psNext)
    for (const char* key : {"name", "alias", "deprecated_alias"})
      if (EQUAL(CPLGetXMLValue(node, key, ""), name.c_str()))
        return true;
  return false;
}

/// GDAL passes over open options that a driver does not know.
void checkOpenOptions(GDALDataset& dataset, const std::vector<std::string>& given,
                      std::vector<std::string>& warnings) {
  GDALDriver* driver = dataset.GetDriver();
  const char* listed = driver ? driver->GetMetadataItem(GDAL_DMD_OPENOPTIONLIST) : nullptr;
  const CPLXMLTreeCloser xml(listed ? CPLParseXMLString(listed) : nullptr);
  if (!xml)
    return;
  for (const std::string& option : given) {
    const std::string name = option.substr(0, option.find('='));
    if (!hasOpenOption(xml.get(), name))
      warnings.push_back("--oo " + option + ": GDAL's driver " + driver->GetDescription() +
                         " has no such open option");
  }
}

Status checkBands(GDALDataset& dataset, const std::string& path, int band) {
  const int count = dataset.GetRasterCount();
  if (count == 0) {
    CSLConstList parts = dataset.GetMetadata("SUBDATASETS");
    const char* first = CSLFetchNameValue(parts, "SUBDATASET_1_NAME");
    return bad(path, first ? std::string("holds several rasters; name one of them, for example '") +
                                 first + "'"
                           : "has no raster band");
  }
  if (band < 1 || band > count)
    return bad(path,
               "has no band " + std::to_string(band) + "; -b may be 1 to " + std::to_string(count));
  const GDALDataType type = dataset.GetRasterBand(band)->GetRasterDataType();
  if (GDALDataTypeIsComplex(type))
    return bad(path, "has complex numbers (" + std::string(GDALGetDataTypeName(type)) +
                         ") in band " + std::to_string(band) + ", which cannot be heights");
  return {};
}

/// Without a place no coordinate system helps, so this is asked first.
Status checkGeoreferencing(GDALDataset& dataset, const std::string& path) {
  std::array<double, 6> transform{};
  const std::array<double, 6> identity{0, 1, 0, 0, 0, 1};
  if (dataset.GetGeoTransform(transform.data()) == CE_None && transform != identity)
    return {};
  const bool indirect =
      dataset.GetGCPCount() > 0 || dataset.GetMetadata("RPC") || dataset.GetMetadata("GEOLOCATION");
  return bad(path, indirect ? "is placed by control points or a sensor model only; rectify it "
                              "first: gdalwarp INPUT RECTIFIED.tif"
                            : "is not georeferenced; give it a place first: gdal_translate "
                              "-a_ullr ULX ULY LRX LRY -a_srs SRS INPUT PLACED.tif");
}

Status readFrame(GDALDataset& dataset, RasterInput& out) {
  std::array<double, 6> transform{};
  dataset.GetGeoTransform(transform.data());
  if (!out.frame.set(transform, dataset.GetRasterXSize(), dataset.GetRasterYSize(),
                     fullTurn(out.srs)))
    return bad(out.path, "has a geotransform that cannot be inverted; its pixels have no area");
  return {};
}

Status readSrs(GDALDataset& dataset, const InputOptions& options, RasterInput& out) {
  if (!options.sourceSrs.empty()) {
    Result<OGRSpatialReference> given = parseSrs(options.sourceSrs, "-s");
    if (!given.ok())
      return given.status();
    out.srs = *given;
  } else {
    const OGRSpatialReference* own = dataset.GetSpatialRef();
    if (!own || own->IsEmpty())
      return bad(out.path, "has no coordinate system; give it with -s, for example -s EPSG:4326");
    out.srs = *own;
  }
  QMESH_RETURN_IF_ERROR(makeHorizontal(out.srs, out.path));
  out.lonLat = isLonLatWgs84(out.srs);
  return {};
}

} // namespace

Result<RasterInput> describeRaster(const InputOptions& options, bool bathymetry, GDALDataset* host,
                                   std::vector<std::string>& warnings) {
  if (GDALGetDriverCount() == 0)
    GDALAllRegister();
  RasterInput out;
  if (!host)
    QMESH_RETURN_IF_ERROR(checkFormats(options.inputFormats));
  out.path = options.path;
  out.band = options.band;
  out.access = host ? DatasetAccess::ofHost(*host, out.band)
                    : DatasetAccess::byName(out.path, options.inputFormats, options.openOptions);
  const Result<DatasetPtr> opened = out.access.describe();
  if (!opened.ok())
    return opened.status();
  QuietErrors errors;
  GDALDataset& dataset = **opened;
  if (!host && !options.openOptions.empty())
    checkOpenOptions(dataset, options.openOptions, warnings);
  QMESH_RETURN_IF_ERROR(checkBands(dataset, out.path, out.band));
  QMESH_RETURN_IF_ERROR(checkGeoreferencing(dataset, out.path));
  QMESH_RETURN_IF_ERROR(readSrs(dataset, options, out));
  QMESH_RETURN_IF_ERROR(readFrame(dataset, out));
  GDALRasterBand& band = *dataset.GetRasterBand(out.band);
  out.values = PixelValues::of(band, options.sourceNodata, bathymetry, warnings);
  out.coverage = dataCoverage(band);
  int blockWidth = 0;
  int blockHeight = 0;
  band.GetBlockSize(&blockWidth, &blockHeight);
  out.blockBytes = std::size_t(blockWidth) * std::size_t(blockHeight) *
                   std::size_t(GDALGetDataTypeSizeBytes(band.GetRasterDataType()));
  return out;
}

} // namespace qmesh
