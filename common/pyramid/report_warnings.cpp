// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/report.h"

#include <cstdio>

namespace qmesh {
namespace {

std::string threeDigits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

} // namespace

std::vector<std::string> reportWarnings(const BuildReport& report) {
  const LevelStats total = report.total();
  std::vector<std::string> warnings;
  if (!report.anyData)
    warnings.push_back("the DEM lies between the nodes of zoom " + std::to_string(report.maxZoom) +
                       ": the terrain is flat; use a higher zoom");
  if (total.quantizationTiles > 0)
    warnings.push_back(std::to_string(total.quantizationTiles) + " of " +
                       std::to_string(total.tiles) +
                       " tiles exceed their max error because of the rounding to the format's "
                       "15 bits; layer.json tells the error of each zoom");
  if (total.coarseTiles > 0)
    warnings.push_back(std::to_string(total.coarseTiles) +
                       " tiles hold heights too far apart for an exact fit with their neighbours: "
                       "gaps of up to " +
                       threeDigits(total.largestCoarseStep) +
                       " m (is a void value missing? see -a, --void-fill, --clip-low)");
  return warnings;
}

} // namespace qmesh
