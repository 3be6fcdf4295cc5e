// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "vsi/png_file.h"

#include <gdal_priv.h>

#include "vsi/quiet_errors.h"

namespace qmesh {

Status writePng(const std::string& path, const RgbImage& image) {
  QuietErrors errors;
  GDALDriver* png = GetGDALDriverManager()->GetDriverByName("PNG");
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  if (!png || !memory)
    return {Code::output, "'" + path + "' cannot be written: this GDAL has no PNG driver"};
  const GDALDatasetUniquePtr picture(
      memory->Create("", image.width, image.height, 3, GDT_Byte, nullptr));
  if (!picture)
    return {Code::output, errors.explain("'" + path + "' cannot be written")};
  RgbImage pixels = image; // GDAL takes what it writes as not constant
  const CPLErr filled = picture->RasterIO(GF_Write, 0, 0, image.width, image.height,
                                          pixels.pixels.data(), image.width, image.height, GDT_Byte,
                                          3, nullptr, 3, GSpacing(3) * image.width, 1, nullptr);
  GDALDatasetUniquePtr file;
  if (filled == CE_None)
    file.reset(png->CreateCopy(path.c_str(), picture.get(), FALSE, nullptr, nullptr, nullptr));
  file.reset();
  if (filled != CE_None || !errors.firstFailure().empty())
    return {Code::output, errors.explain("'" + path + "' cannot be written")};
  return {};
}

} // namespace qmesh
