// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/validate.h"

#include "base/text.h"
#include "options/level_spec.h"
#include "options/method_rows.h"

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

/// One SPEC has a value within its row's range at every zoom.
Status checkSpec(const OptionRow& row, const std::string& text, int first, int last) {
  const std::string name = "--" + row.name;
  const Result<LevelSpec> spec = LevelSpec::parse(text);
  if (!spec.ok())
    return Status(spec.status().code(), name + ": " + spec.status().message());
  for (int zoom = first; zoom <= last; ++zoom) {
    const Result<double> value = spec->at(zoom);
    if (!value.ok())
      return Status(value.status().code(), name + " " + text + ": " + value.status().message());
    if (*value < row.minimum.value_or(0) || *value > row.maximum.value_or(*value))
      return Status(Code::usage, name + " " + text + ": " + formatNumber(*value) + " at zoom " +
                                     std::to_string(zoom) + " is not " + row.rangeText());
  }
  return {};
}

/// The method that a row's sentence begins with; empty for rows of all methods.
std::string methodOf(const OptionRow& row) {
  const std::size_t colon = row.help.find(": ");
  const std::string word = row.help.substr(0, colon == std::string::npos ? 0 : colon);
  return word.find_first_not_of("abcdefghijklmnopqrstuvwxyz ") == std::string::npos ? word : "";
}

bool isPointSet(const std::string& method) {
  return method == "grid" || method == "random" || method == "hierarchy" || method == "wlop";
}

/// Options of a method that is not the chosen one: somebody expects something of them.
void warnOfOtherMethods(const BuildOptions& options, std::vector<std::string>& warnings) {
  const BuildOptions defaults;
  for (const OptionRow& row : methodRows({})) {
    const std::string method = methodOf(row);
    const bool used = method.empty() || method == options.method ||
                      (method == "point sets" && isPointSet(options.method));
    if (!used && row.get(options) != row.get(defaults))
      warnings.push_back("--" + row.name + " has no effect with --method " + options.method +
                         ": it belongs to " + method);
  }
}

} // namespace

Status checkSpecs(const BuildOptions& options, int first, int last) {
  for (const OptionRow& row : methodRows({})) {
    const std::string text = row.type == OptionType::spec ? row.get(options) : std::string();
    const bool overridden = row.name == "screen-error" && !options.maxError.empty();
    if (!text.empty() && !overridden)
      QMESH_RETURN_IF_ERROR(checkSpec(row, text, first, last));
  }
  return {};
}

Status validate(const BuildOptions& options, std::vector<std::string>& warnings) {
  QMESH_RETURN_IF_ERROR(
      checkOrder(options.minZoom, options.maxZoom, "the minimum zoom", "the maximum zoom"));
  QMESH_RETURN_IF_ERROR(checkOrder(options.minX, options.maxX, "--min-x", "--max-x"));
  QMESH_RETURN_IF_ERROR(checkOrder(options.minY, options.maxY, "--min-y", "--max-y"));
  QMESH_RETURN_IF_ERROR(checkOrder(options.clipLow, options.clipHigh, "--clip-low", "--clip-high"));
  const int first = options.minZoom.value_or(0);
  QMESH_RETURN_IF_ERROR(checkSpecs(options, first, options.maxZoom.value_or(first)));
  if (!options.extentSrs.empty() && !options.extent)
    return Status(Code::usage, "--te-srs needs --te: the box it is the coordinate system of");
  if (!options.cesium.empty() && options.preview == Preview::none)
    warnings.push_back("--cesium has no effect without a preview page (-w cesium)");
  if (options.compareTile && !options.compare)
    return Status(Code::usage, "--compare-tile says where --compare works; name both");
  if (options.schedule != Schedule::fourColour && options.border == BorderMode::shared)
    warnings.push_back("--schedule has no effect without --border inherit");
  if (!options.compare)
    warnOfOtherMethods(options, warnings);
  if (options.minZoom.value_or(0) > 0)
    warnings.push_back("CesiumJS needs zoom 0 to begin with: terrain from zoom " +
                       std::to_string(*options.minZoom) + " on is of use to other programs only");
  return {};
}

} // namespace qmesh
