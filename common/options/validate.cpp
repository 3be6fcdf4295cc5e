// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/validate.h"

#include <algorithm>

#include "base/text.h"
#include "options/method_rows.h"
#include "simplify/method_specs.h"

namespace qmesh {

namespace {

/// Both ends given and the wrong way round.
template <class T>
Status checkOrder(const std::optional<T>& low, const std::optional<T>& high, const char* lowName,
                  const char* highName) {
  if (!low || !high || *low <= *high)
    return {};
  return Status(Code::usage,
                std::string(lowName) + " is above " + highName + "; swap them or omit one");
}

/// Options of a method that is not the chosen one: somebody expects something of them.
void warnOfOtherMethods(const BuildOptions& options, std::vector<std::string>& warnings) {
  const BuildOptions defaults;
  for (const OptionRow& row : methodRows({})) {
    const bool used = row.methods.empty() ||
                      std::count(row.methods.begin(), row.methods.end(), options.method.name) > 0;
    if (!used && row.get(options) != row.get(defaults))
      warnings.push_back("--" + row.name + " has no effect with --method " + options.method.name +
                         ": it is an option of " + row.methodsText());
  }
}

} // namespace

Status validate(const BuildOptions& options, std::vector<std::string>& warnings) {
  QMESH_RETURN_IF_ERROR(checkOrder(options.tiling.minZoom, options.tiling.maxZoom,
                                   "the minimum zoom", "the maximum zoom"));
  QMESH_RETURN_IF_ERROR(checkOrder(options.tiling.minX, options.tiling.maxX, "--min-x", "--max-x"));
  QMESH_RETURN_IF_ERROR(checkOrder(options.tiling.minY, options.tiling.maxY, "--min-y", "--max-y"));
  QMESH_RETURN_IF_ERROR(
      checkOrder(options.heights.clipLow, options.heights.clipHigh, "--clip-low", "--clip-high"));
  const int first = options.tiling.minZoom.value_or(0);
  QMESH_RETURN_IF_ERROR(checkSpecs(options.method, first, options.tiling.maxZoom.value_or(first)));
  if (!options.input.extentSrs.empty() && !options.input.extent)
    return Status(Code::usage, "--te-srs needs --te");
  if (!options.output.cesium.empty() && options.output.preview == Preview::none)
    warnings.push_back("--cesium has no effect without a preview page (-w cesium)");
  if (options.compare.tile && !options.compare.enabled)
    return Status(Code::usage, "--compare-tile needs --compare");
  if (options.tiling.schedule != Schedule::fourColour &&
      options.tiling.border == BorderMode::shared)
    warnings.push_back("--schedule has no effect without --border inherit");
  if (!options.compare.enabled)
    warnOfOtherMethods(options, warnings);
  if (options.tiling.minZoom.value_or(0) > 0)
    warnings.push_back("CesiumJS cannot show a tileset that starts at zoom " +
                       std::to_string(*options.tiling.minZoom) + ": it needs zoom 0");
  return {};
}

} // namespace qmesh
