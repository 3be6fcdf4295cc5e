// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "one_tile.h"
#include "places.h"
#include "validate/dem_measure.h"
#include "validate/finding_counts.h"
#include "validate/survey.h"

namespace qmesh {

/// All that one run has to say; parts that were not asked for are absent.
struct InfoReport {
  std::string path; ///< as the user wrote it
  const Tileset* set = nullptr;
  bool describe = true; ///< the set: not where only places or one tile were asked for
  std::optional<Survey> survey;
  const FindingCounts* book = nullptr;
  std::optional<TileReport> tile;
  std::optional<DemReport> dem;
  std::optional<std::vector<Sample>> samples;
};

/// For people, and as JSON for programs (data/schema/qmeshinfo.schema.json); with a line end.
std::string infoText(const InfoReport& report);
std::string infoJson(const InfoReport& report);

/// Every finding there is, for --list-findings.
std::string findingsText();
std::string findingsJson();

} // namespace qmesh
