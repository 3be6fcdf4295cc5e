// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/survey.h"

#include <algorithm>

#include "base/in_order.h"
#include "surface/surface_raster.h"
#include "validate/seam_walk.h"
#include "validate/tileset_checks.h"

namespace qmesh {

namespace {

/// The tiles of a level row by row, from the rectangles that list them.
class TileRows {
 public:
  TileRows(int zoom, const std::vector<TileRange>& ranges) : zoom_(zoom), ranges_(ranges) {
    if (!ranges.empty())
      beginRow(ranges.front().y0);
  }

  std::optional<TileId> next() {
    while (place_ == row_.size()) {
      if (row_.empty() && begun_ == ranges_.size())
        return std::nullopt;
      beginRow(row_.empty() ? ranges_[begun_].y0 : y_ + 1);
    }
    const TileId tile{zoom_, x_, y_};
    if (x_++ == row_[place_].x1 && ++place_ < row_.size())
      x_ = row_[place_].x0;
    return tile;
  }

 private:
  void beginRow(std::uint32_t y) {
    y_ = y;
    row_.erase(std::remove_if(row_.begin(), row_.end(),
                              [&](const TileRange& range) { return range.y1 < y; }),
               row_.end());
    while (begun_ < ranges_.size() && ranges_[begun_].y0 == y)
      row_.push_back(ranges_[begun_++]);
    std::sort(row_.begin(), row_.end(),
              [](const TileRange& a, const TileRange& b) { return a.x0 < b.x0; });
    place_ = 0;
    x_ = row_.empty() ? 0 : row_[0].x0;
  }

  int zoom_;
  const std::vector<TileRange>& ranges_; ///< sorted by y0
  std::size_t begun_ = 0;
  std::vector<TileRange> row_; ///< those that have tiles in row y_
  std::size_t place_ = 0;
  std::uint32_t x_ = 0, y_ = 0;
};

/// What is kept of a tile until its turn comes.
struct SeenTile {
  SurveyLevel stats; ///< of this tile
  Findings findings;
  std::array<TileEdge, 4> edges;
  Status fault;
};

/// The walk over a set.
class Surveyor {
 public:
  Surveyor(const OpenedTileset& opened, const SurveyPlan& plan, const Progress& progress)
      : set_(opened.set), announced_(opened.announced), plan_(plan), progress_(progress),
        total_(tilesOf(opened.set, plan)) {}

  Status level(int zoom);
  Survey& result() { return survey_; }

 private:
  SeenTile look(TileId tile) const;
  void check(TileId tile, const ReadTile& read, SeenTile& seen) const;
  Status take(TileId tile, SeenTile seen, SurveyLevel& level, SeamWalk& seams);

  const Tileset& set_;
  bool announced_;
  const SurveyPlan& plan_;
  const Progress& progress_;
  std::uint64_t total_;
  std::uint64_t done_ = 0;
  Survey survey_;
};

void fill(SurveyLevel& stats, const ReadTile& read, std::size_t storedBytes) {
  const TileMesh& mesh = *read.mesh;
  const auto has = [&](int id) {
    return std::uint64_t(std::count(read.extensions.begin(), read.extensions.end(), id) > 0);
  };
  const auto [low, high] = std::minmax_element(mesh.q.begin(), mesh.q.end());
  stats.bytes = storedBytes;
  stats.tiles = 1;
  stats.vertices = mesh.vertexCount();
  stats.triangles = mesh.triangleCount();
  stats.lowest = decodedHeight(mesh.header, *low);
  stats.highest = decodedHeight(mesh.header, *high);
  if (stats.lowest > stats.highest)
    std::swap(stats.lowest, stats.highest);
  stats.normals = has(1);
  stats.waterMasks = has(2);
  stats.metadata = has(4);
  stats.compressed = read.compressed;
}

void addStats(SurveyLevel& to, const SurveyLevel& tile) {
  if (tile.tiles == 0)
    return;
  to.lowest = to.tiles == 0 ? tile.lowest : std::min(to.lowest, tile.lowest);
  to.highest = to.tiles == 0 ? tile.highest : std::max(to.highest, tile.highest);
  to.tiles += tile.tiles;
  to.bytes += tile.bytes;
  to.vertices += tile.vertices;
  to.triangles += tile.triangles;
  to.normals += tile.normals;
  to.waterMasks += tile.waterMasks;
  to.metadata += tile.metadata;
  to.compressed += tile.compressed;
}

SeenTile Surveyor::look(TileId tile) const {
  SeenTile seen;
  const Result<FileBytes> bytes = set_.readBytes(tile);
  if (!bytes.ok()) {
    seen.fault = bytes.status();
    seen.findings.push_back({218, tileName(tile), bytes.status().message()});
    return seen;
  }
  if (!*bytes) {
    seen.findings.push_back({601, tileName(tile), set_.tilePath(tile)});
    return seen;
  }
  const ReadTile read =
      readTileBytes(**bytes, set_.extensionLengths(), tileName(tile), seen.findings);
  if (!read.mesh) {
    if (!seen.findings.empty())
      seen.fault = Status(Code::input, "'" + set_.tilePath(tile) +
                                           "': " + findingKind(seen.findings[0].code).title + ": " +
                                           seen.findings[0].what);
    return seen;
  }
  fill(seen.stats, read, (*bytes)->size());
  if (plan_.book)
    check(tile, read, seen);
  return seen;
}

void Surveyor::check(TileId tile, const ReadTile& read, SeenTile& seen) const {
  const Scheme scheme = set_.scheme();
  const TileContext context{tile, scheme.box(tile), scheme.geometricError(tile.z), tileName(tile)};
  checkMesh(*read.mesh, context, seen.findings);
  checkHeader(*read.mesh, earthFixed(*read.mesh, context.box), context, seen.findings);
  if (announced_)
    checkExtensions(read, context, set_.layer(), set_.available(), seen.findings);
  seen.edges = tileEdges(*read.mesh);
}

Status Surveyor::take(TileId tile, SeenTile seen, SurveyLevel& level, SeamWalk& seams) {
  if (!progress_(double(++done_) / double(std::max<std::uint64_t>(total_, 1))))
    return {Code::interrupted, "stopped before the end"};
  if (!plan_.book && !seen.fault.ok())
    return seen.fault;
  addStats(level, seen.stats);
  if (!plan_.book)
    return {};
  if (seen.stats.tiles > 0)
    seams.add(tile, std::move(seen.edges), seen.findings);
  plan_.book->add(seen.findings);
  return {};
}

Status Surveyor::level(int zoom) {
  SurveyLevel level;
  level.zoom = zoom;
  SeamWalk seams(set_.scheme(), zoom, survey_.seams);
  TileRows rows(zoom, set_.available().ranges(zoom));
  QMESH_RETURN_IF_ERROR(inOrder(
      plan_.threads, [&] { return rows.next(); }, [&](TileId tile, int) { return look(tile); },
      [&](TileId tile, SeenTile seen) { return take(tile, std::move(seen), level, seams); }));
  Findings findings;
  seams.finish(findings);
  if (plan_.book && !set_.singleTile())
    plan_.book->add(findings);
  survey_.tiles += level.tiles;
  survey_.levels.push_back(level);
  return {};
}

/// Files in the folder that no client asks for.
void checkFiles(const OpenedTileset& opened, const SurveyPlan& plan) {
  if (!opened.listed)
    return;
  LayerJson bare = opened.set.layer();
  bare.available.clear();
  bare.metadataAvailability = 0;
  const Result<Tileset> there = Tileset::of(opened.set.layerPath(), std::move(bare));
  if (!there.ok())
    return;
  for (int zoom = plan.firstZoom; zoom <= there->available().maxZoom(); ++zoom) {
    TileRows rows(zoom, there->available().ranges(zoom));
    while (const auto tile = rows.next())
      if (!opened.set.lists(*tile))
        plan.book->add({{602, tileName(*tile), there->tilePath(*tile)}});
  }
}

void checkCompression(const Survey& survey, FindingCounts& book) {
  std::uint64_t compressed = 0;
  for (const SurveyLevel& level : survey.levels)
    compressed += level.compressed;
  const std::string what =
      std::to_string(compressed) + " of " + std::to_string(survey.tiles) + " tiles";
  if (compressed > 0)
    book.add({{611, "set", what}});
  if (compressed > 0 && compressed < survey.tiles)
    book.add({{612, "set", what}});
}

} // namespace

std::uint64_t tilesOf(const Tileset& set, const SurveyPlan& plan) {
  std::uint64_t tiles = 0;
  for (int zoom = plan.firstZoom; zoom <= plan.lastZoom; ++zoom)
    tiles += set.available().count(zoom);
  return tiles;
}

Result<Survey> surveyTileset(const OpenedTileset& opened, const SurveyPlan& plan,
                             const Progress& progress) {
  const bool whole = plan.book && !opened.set.singleTile();
  if (whole) {
    plan.book->add(opened.layerFindings);
    if (opened.listed) {
      Findings findings;
      checkListedTiles(opened.set.layer(), opened.set.available(), findings);
      plan.book->add(findings);
    }
  }
  Surveyor surveyor(opened, plan, progress);
  for (int zoom = plan.firstZoom; zoom <= plan.lastZoom; ++zoom)
    QMESH_RETURN_IF_ERROR(surveyor.level(zoom));
  if (whole) {
    checkFiles(opened, plan);
    checkCompression(surveyor.result(), *plan.book);
  }
  return std::move(surveyor.result());
}

} // namespace qmesh
