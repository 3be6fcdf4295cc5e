// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/validate.h"

#include "base/text.h"
#include "options/level_spec.h"

namespace qmesh {

namespace {

/// Both ends given and the wrong way round.
template <class T>
Status checkOrder(const std::optional<T>& low, const std::optional<T>& high, const char* lowName,
                  const char* highName) {
  if (!low || !high || *low <= *high)
    return {};
  return Status(Code::usage, std::string(lowName) + " is above " + highName +
                                 "; exchange them or leave one out");
}

/// The levels known so far each have a value.
Status checkSpec(const BuildOptions& options, const std::string& text, const char* name) {
  const Result<LevelSpec> spec = LevelSpec::parse(text);
  if (!spec.ok())
    return Status(spec.status().code(), std::string(name) + ": " + spec.status().message());
  const int first = options.minZoom.value_or(0);
  for (int zoom = first; zoom <= options.maxZoom.value_or(first); ++zoom) {
    const Result<double> value = spec->at(zoom);
    if (!value.ok())
      return Status(value.status().code(),
                    std::string(name) + " " + text + ": " + value.status().message());
  }
  return {};
}

} // namespace

Status validate(const BuildOptions& options, std::vector<std::string>& warnings) {
  QMESH_RETURN_IF_ERROR(
      checkOrder(options.minZoom, options.maxZoom, "the minimum zoom", "the maximum zoom"));
  QMESH_RETURN_IF_ERROR(checkOrder(options.minX, options.maxX, "--min-x", "--max-x"));
  QMESH_RETURN_IF_ERROR(checkOrder(options.minY, options.maxY, "--min-y", "--max-y"));
  QMESH_RETURN_IF_ERROR(checkOrder(options.clipLow, options.clipHigh, "--clip-low", "--clip-high"));
  if (!options.maxError.empty())
    QMESH_RETURN_IF_ERROR(checkSpec(options, options.maxError, "--max-error"));
  else
    QMESH_RETURN_IF_ERROR(checkSpec(options, options.screenError, "--screen-error"));
  if (!options.extentSrs.empty() && !options.extent)
    return Status(Code::usage, "--te-srs needs --te: the box it is the coordinate system of");
  if (!options.cesium.empty() && options.preview == Preview::none)
    warnings.push_back("--cesium has no effect without a preview page (-w cesium)");
  if (options.minZoom.value_or(0) > 0)
    warnings.push_back("CesiumJS needs zoom 0 to begin with: terrain from zoom " +
                       std::to_string(*options.minZoom) +
                       " on shows only where it lies over another set");
  return {};
}

} // namespace qmesh
