// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/error_raster.h"

#include <array>
#include <limits>

#include <cpl_string.h>

#include "vsi/quiet_errors.h"

namespace qmesh {

Result<ErrorRaster> ErrorRaster::create(const std::string& path, const RasterInput& dem, int step,
                                        int columns, int rows) {
  QuietErrors errors;
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "3");
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  DatasetPtr file;
  if (driver)
    file.reset(driver->Create(path.c_str(), columns, rows, 1, GDT_Float32, options.List()));
  if (!file)
    return Status(Code::output, errors.explain("'" + path + "' cannot be written"));
  std::array<double, 6> place = dem.frame.toWorld;
  for (const std::size_t k : {1u, 2u, 4u, 5u})
    place[k] *= step;
  GDALRasterBand* band = file->GetRasterBand(1);
  file->SetGeoTransform(place.data());
  file->SetSpatialRef(&dem.srs);
  band->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  band->SetDescription("terrain minus DEM");
  band->SetUnitType("m");
  return ErrorRaster(path, std::move(file));
}

Status ErrorRaster::write(int column, int row, int width, int height, std::vector<float>& numbers) {
  QuietErrors errors;
  if (file_->GetRasterBand(1)->RasterIO(GF_Write, column, row, width, height, numbers.data(), width,
                                        height, GDT_Float32, 0, 0, nullptr) != CE_None)
    return {Code::output, errors.explain("'" + path_ + "' cannot be written")};
  return {};
}

Status ErrorRaster::close() {
  QuietErrors errors;
  file_.reset();
  if (!errors.firstFailure().empty())
    return {Code::output, errors.explain("'" + path_ + "' cannot be written")};
  return {};
}

} // namespace qmesh
