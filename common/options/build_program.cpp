// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "base/exit_codes.h"
#include "options/program_text.h"

namespace qmesh {

ProgramText buildProgram() {
  ProgramText text;
  text.name = "gdal2qmesh";
  text.arguments = "[options] INPUT [OUTPUT]";
  text.sentence =
      "Converts a digital elevation model (DEM) to a quantized-mesh tileset for CesiumJS.";
  text.inputHint = "several DEMs go into a VRT: gdalbuildvrt";
  text.specs = true;
  text.examples = {
      {"gdal2qmesh dem.tif", "All zooms up to the native zoom of the DEM, into the folder dem."},
      {"gdal2qmesh -z 0-12 -w cesium dem.tif terrain", "Zooms 0 to 12, with a preview page."},
      {"gdal2qmesh -s EPSG:32611 -a -9999 --void-fill interpolate dem.asc terrain",
       "A DEM without a coordinate system and nodata value; voids are interpolated."},
      {"gdal2qmesh --max-error 0-9:2000/2^z,10-:0.5 dem.tif terrain",
       "Errors in metres instead of pixels: 0.5 m from zoom 10."},
      {"gdal2qmesh --te -120 30 -110 40 --te-srs EPSG:4326 --memory 2GB big.vrt part",
       "A part of a large DEM, with at most 2 GB of memory."},
      {"gdal2qmesh --dry-run big.vrt",
       "Print the number of tiles and the estimated size and time."},
  };
  for (const EnumRow<Code>& code : EnumTable<Code>::kRows)
    text.exitCodes.push_back({static_cast<int>(code.value), code.help});
  return text;
}

} // namespace qmesh
