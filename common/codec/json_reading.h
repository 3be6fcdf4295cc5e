// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// Private header: not installed.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/status.h"
#include "tiling/availability.h"

/// What the readers of layer.json and of a tile's metadata have in common.
namespace qmesh::json_reading {

/// Code::input: `subject` "cannot be used", and why.
Status fault(const std::string& subject, const std::string& what);

/// The JSON object in `text`; at most 256 MB and 64 levels of nesting.
Result<nlohmann::json> parseObject(const std::string& subject, const std::string& text);

/// The member, or a null value where `object` has none.
const nlohmann::json& member(const nlohmann::json& object, const char* key);

/// `fallback` for what is not a finite number.
double numberOf(const nlohmann::json& value, double fallback);

/// The lists of rectangles of the levels from `firstZoom` on; a null value is none.
Status readLevels(const std::string& subject, const nlohmann::json& levels, const Scheme& scheme,
                  int firstZoom, std::vector<std::vector<TileRange>>& to);

} // namespace qmesh::json_reading
