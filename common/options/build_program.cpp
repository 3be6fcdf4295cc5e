// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "base/exit_codes.h"
#include "options/program_text.h"

namespace qmesh {

ProgramText buildProgram() {
  ProgramText text;
  text.name = "gdal2qmesh";
  text.arguments = "[options] INPUT [OUTPUT]";
  text.sentence = "Turns a digital elevation model into quantized-mesh terrain for CesiumJS.";
  text.specs = true;
  text.examples = {
      {"gdal2qmesh dem.tif", "All zooms the DEM has detail for, into the folder dem."},
      {"gdal2qmesh -z 0-12 -w cesium dem.tif terrain",
       "Zooms 0 to 12, with a page that shows them."},
      {"gdal2qmesh -s EPSG:32611 -a -9999 --void-fill interpolate dem.asc terrain",
       "A DEM that does not say its coordinate system, nor that -9999 marks voids."},
      {"gdal2qmesh --max-error 0-9:2000/2^z,10-:0.5 dem.tif terrain",
       "Errors in metres instead of pixels: half a metre from zoom 10 on."},
      {"gdal2qmesh --te -120 30 -110 40 --te-srs EPSG:4326 --memory 2GB big.vrt part",
       "A part of a large DEM, with 2 GB of memory."},
      {"gdal2qmesh --dry-run big.vrt", "How many tiles it would be, and how long it would take."},
  };
  for (const EnumRow<Code>& code : EnumTable<Code>::kRows)
    text.exitCodes.push_back({static_cast<int>(code.value), code.help});
  return text;
}

} // namespace qmesh
