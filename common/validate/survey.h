// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "tileset/tileset.h"
#include "validate/finding_counts.h"
#include "validate/open_tileset.h"
#include "validate/seam_checks.h"

namespace qmesh {

/// What the tiles of a level hold together.
struct SurveyLevel {
  int zoom = 0;
  std::uint64_t tiles = 0; ///< read
  std::uint64_t bytes = 0; ///< as stored
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  double lowest = 0; ///< metres, of vertices
  double highest = 0;
  std::uint64_t normals = 0; ///< tiles with that extension
  std::uint64_t waterMasks = 0;
  std::uint64_t metadata = 0;
  std::uint64_t compressed = 0;
};

/// What reading the tiles of a set has shown.
struct Survey {
  std::vector<SurveyLevel> levels;
  std::uint64_t tiles = 0; ///< read
  SeamReport seams;
};

/// Which tiles, and how.
struct SurveyPlan {
  int firstZoom = 0;
  int lastZoom = 0;
  int threads = 1;
  FindingCounts* book = nullptr; ///< null: statistics only
};

/// Reads every listed tile of the zooms, level by level and row by row. With a book everything is
/// checked: tiles, seams, and the set's list. Memory: a batch of tiles and the edges of two rows.
/// Code::interrupted when `progress` asks for it; without a book also Code::input for a tile that
/// cannot be read.
Result<Survey> surveyTileset(const OpenedTileset& opened, const SurveyPlan& plan,
                             const Progress& progress);

/// Tiles that surveyTileset() will read.
std::uint64_t tilesOf(const Tileset& set, const SurveyPlan& plan);

} // namespace qmesh
