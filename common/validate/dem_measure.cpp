// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/dem_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "base/in_order.h"
#include "source/crs.h"
#include "source/pixel_reader.h"
#include "tileset/surface_cache.h"
#include "validate/error_raster.h"

namespace qmesh {

namespace {

constexpr std::int64_t kMostCells = 4000000;        ///< chosen by the default step
constexpr std::int64_t kMostKept = 2000000;         ///< errors kept a zoom for p99
constexpr int kBlockColumns = 256, kBlockRows = 64; ///< cells measured
constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

/// The cells of the DEM that are looked at: the middle one of each square of step x step.
struct CellGrid {
  int step = 1;
  int columns = 0, rows = 0;

  int cell(int k) const { return k * step + (step - 1) / 2; }
};

int countOf(int cells, int step) {
  return std::max(1, (cells - 1 - (step - 1) / 2) / step + 1);
}

CellGrid gridOf(const PixelFrame& frame, int demStep) {
  const int width = int(frame.width), height = int(frame.height);
  CellGrid grid;
  grid.step = std::max(1, demStep);
  while (demStep == 0 &&
         std::int64_t(countOf(width, grid.step)) * countOf(height, grid.step) > kMostCells)
    ++grid.step;
  grid.step = std::min(grid.step, std::max(1, std::min(width, height)));
  grid.columns = countOf(width, grid.step);
  grid.rows = countOf(height, grid.step);
  return grid;
}

/// A rectangle of the grid.
struct Block {
  int column = 0, row = 0, width = 0, height = 0;
};

/// What a block adds to a zoom.
struct BlockError {
  LevelError sums; ///< mean and rms hold sums
  std::vector<float> kept;
};

struct MeasuredBlock {
  Status fault;
  std::uint64_t voids = 0;
  std::vector<BlockError> zooms;
  std::vector<float> raster; ///< of the last zoom; empty where not asked for
};

/// What one thread works with.
class Worker {
 public:
  static Result<std::unique_ptr<Worker>> open(const Tileset& set, const RasterInput& dem) {
    Result<DatasetPtr> dataset = dem.access.open();
    if (!dataset.ok())
      return dataset.status();
    Result<PointTransform> transform = PointTransform::create(dem.srs, lonLatSrs(), dem.path);
    if (!transform.ok())
      return transform.status();
    return std::make_unique<Worker>(set, dem, *std::move(dataset), *std::move(transform));
  }

  Worker(const Tileset& set, const RasterInput& dem, DatasetPtr dataset, PointTransform transform)
      : scheme_(set.scheme()), dem_(dem), dataset_(std::move(dataset)),
        transform_(std::move(transform)),
        reader_(*dataset_->GetRasterBand(dem.band), dem, PixelLevel::full(dem.frame), 0),
        tiles_(set) {}

  MeasuredBlock measure(const Block& block, const CellGrid& grid, const std::vector<int>& zooms,
                        std::int64_t keepEvery, bool raster);

 private:
  struct Cell {
    double lon = 0, lat = 0;
    float height = kVoid;
  };
  Status readCells(const Block& block, const CellGrid& grid);
  Status measureZoom(int zoom, const Block& block, const CellGrid& grid, std::int64_t keepEvery,
                     BlockError& out, std::vector<float>* raster);

  Scheme scheme_;
  const RasterInput& dem_;
  DatasetPtr dataset_;
  PointTransform transform_;
  PixelReader reader_;
  SurfaceCache tiles_;
  PixelWindow window_;
  std::vector<Cell> cells_;
};

Status Worker::readCells(const Block& block, const CellGrid& grid) {
  cells_.assign(std::size_t(block.width) * std::size_t(block.height), Cell());
  window_.column = grid.cell(block.column);
  window_.width = grid.cell(block.column + block.width - 1) - window_.column + 1;
  window_.height = 1;
  for (int r = 0; r < block.height; ++r) {
    window_.row = grid.cell(block.row + r);
    QMESH_RETURN_IF_ERROR(reader_.read(window_));
    for (int c = 0; c < block.width; ++c) {
      Cell& cell = cells_[std::size_t(r) * std::size_t(block.width) + std::size_t(c)];
      const int column = grid.cell(block.column + c);
      const float height = window_.at(column, window_.row);
      dem_.frame.toPlace(column + 0.5, window_.row + 0.5, cell.lon, cell.lat);
      if (height == height && transform_.apply(cell.lon, cell.lat))
        cell.height = height;
    }
  }
  return {};
}

Status Worker::measureZoom(int zoom, const Block& block, const CellGrid& grid,
                           std::int64_t keepEvery, BlockError& out, std::vector<float>* raster) {
  LevelError& sums = out.sums;
  sums.zoom = zoom;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    const Cell& cell = cells_[k];
    if (cell.height != cell.height)
      continue;
    const auto position = tileAt(scheme_, zoom, cell.lon, cell.lat);
    std::optional<double> surface;
    if (position) {
      const auto found = tiles_.heightAt(*position);
      if (!found.ok())
        return found.status();
      surface = *found;
    }
    if (!surface) {
      ++sums.uncovered;
      continue;
    }
    const double error = *surface - double(cell.height);
    if (sums.cells == 0 || std::abs(error) > sums.max) {
      sums.max = std::abs(error);
      sums.maxLon = cell.lon;
      sums.maxLat = cell.lat;
    }
    ++sums.cells;
    sums.mean += error;
    sums.rms += error * error;
    const std::int64_t row = block.row + std::int64_t(k) / block.width;
    const std::int64_t column = block.column + std::int64_t(k) % block.width;
    if ((row * grid.columns + column) % keepEvery == 0)
      out.kept.push_back(float(std::abs(error)));
    if (raster)
      (*raster)[k] = float(error);
  }
  return {};
}

MeasuredBlock Worker::measure(const Block& block, const CellGrid& grid,
                              const std::vector<int>& zooms, std::int64_t keepEvery, bool raster) {
  MeasuredBlock measured;
  measured.fault = readCells(block, grid);
  if (!measured.fault.ok())
    return measured;
  for (const Cell& cell : cells_)
    measured.voids += cell.height != cell.height;
  measured.zooms.resize(zooms.size());
  if (raster)
    measured.raster.assign(cells_.size(), kVoid);
  for (std::size_t k = 0; k < zooms.size() && measured.fault.ok(); ++k) {
    const bool last = k + 1 == zooms.size();
    measured.fault = measureZoom(zooms[k], block, grid, keepEvery, measured.zooms[k],
                                 raster && last ? &measured.raster : nullptr);
  }
  return measured;
}

void addTo(LevelError& level, const LevelError& block) {
  if (block.cells > 0 && (level.cells == 0 || block.max > level.max)) {
    level.max = block.max;
    level.maxLon = block.maxLon;
    level.maxLat = block.maxLat;
  }
  level.cells += block.cells;
  level.uncovered += block.uncovered;
  level.mean += block.mean;
  level.rms += block.rms;
}

void finish(LevelError& level, std::vector<float>& kept) {
  if (level.cells == 0)
    return;
  level.mean /= double(level.cells);
  level.rms = std::sqrt(level.rms / double(level.cells));
  if (kept.empty())
    return;
  const auto place = kept.begin() + std::ptrdiff_t((kept.size() * 99 + 99) / 100) - 1;
  std::nth_element(kept.begin(), place, kept.end());
  level.p99 = double(*place);
}

std::vector<int> zoomsWithTiles(const Tileset& set, const MeasurePlan& plan) {
  std::vector<int> zooms;
  for (int zoom = plan.firstZoom; zoom <= plan.lastZoom; ++zoom)
    if (set.available().count(zoom) > 0 || zoom > set.available().maxZoom())
      zooms.push_back(zoom);
  return zooms;
}

/// Sums of all blocks.
class Totals {
 public:
  Totals(DemReport& report, const std::vector<int>& zooms, std::int64_t cells)
      : report_(report), kept_(zooms.size()), keepEvery_((cells + kMostKept - 1) / kMostKept) {
    report_.levels.resize(zooms.size());
    for (std::size_t k = 0; k < zooms.size(); ++k)
      report_.levels[k].zoom = zooms[k];
  }

  /// Of how many cells one is kept for the percentile.
  std::int64_t keepEvery() const { return keepEvery_; }

  void add(const Block& block, const MeasuredBlock& measured) {
    report_.cells += std::uint64_t(block.width) * std::uint64_t(block.height);
    report_.voids += measured.voids;
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      const std::vector<float>& more = measured.zooms[k].kept;
      addTo(report_.levels[k], measured.zooms[k].sums);
      kept_[k].insert(kept_[k].end(), more.begin(), more.end());
    }
  }

  void finishAll() {
    for (std::size_t k = 0; k < kept_.size(); ++k)
      finish(report_.levels[k], kept_[k]);
  }

 private:
  DemReport& report_;
  std::vector<std::vector<float>> kept_;
  std::int64_t keepEvery_;
};

Result<std::vector<std::unique_ptr<Worker>>> openWorkers(const Tileset& set, const RasterInput& dem,
                                                         int count) {
  std::vector<std::unique_ptr<Worker>> workers;
  for (int k = 0; k < count; ++k) {
    Result<std::unique_ptr<Worker>> worker = Worker::open(set, dem);
    if (!worker.ok())
      return worker.status();
    workers.push_back(*std::move(worker));
  }
  return workers;
}

/// The blocks of a grid, row by row.
class BlockList {
 public:
  explicit BlockList(const CellGrid& grid) : grid_(grid) {}

  std::optional<Block> next() {
    if (row_ >= grid_.rows)
      return std::nullopt;
    const Block block = {column_, row_, std::min(kBlockColumns, grid_.columns - column_),
                         std::min(kBlockRows, grid_.rows - row_)};
    column_ += kBlockColumns;
    if (column_ >= grid_.columns) {
      column_ = 0;
      row_ += kBlockRows;
    }
    return block;
  }

 private:
  CellGrid grid_;
  int column_ = 0, row_ = 0;
};

} // namespace

Result<DemReport> measureAgainstDem(const Tileset& set, const MeasurePlan& plan,
                                    const InputOptions& input, const HeightOptions& heights,
                                    std::vector<std::string>& warnings, const Progress& progress) {
  const Result<RasterInput> dem = describeRaster(input, heights.bathymetry, nullptr, warnings);
  if (!dem.ok())
    return dem.status();
  const CellGrid grid = gridOf(dem->frame, plan.step);
  const std::vector<int> zooms = zoomsWithTiles(set, plan);
  const auto workers = openWorkers(set, *dem, plan.threads);
  if (!workers.ok())
    return workers.status();
  std::optional<ErrorRaster> raster;
  if (!plan.errorRaster.empty()) {
    Result<ErrorRaster> file =
        ErrorRaster::create(plan.errorRaster, *dem, grid.step, grid.columns, grid.rows);
    if (!file.ok())
      return file.status();
    raster.emplace(*std::move(file));
  }
  DemReport report;
  report.file = input.path;
  report.step = grid.step;
  const std::int64_t cells = std::int64_t(grid.columns) * grid.rows;
  Totals totals(report, zooms, cells);

  const auto take = [&](const Block& block, MeasuredBlock measured) -> Status {
    QMESH_RETURN_IF_ERROR(measured.fault);
    totals.add(block, measured);
    if (raster)
      QMESH_RETURN_IF_ERROR(
          raster->write(block.column, block.row, block.width, block.height, measured.raster));
    if (!progress(double(report.cells) / double(cells)))
      return {Code::interrupted, "stopped before the end"};
    return {};
  };
  BlockList blocks(grid);
  QMESH_RETURN_IF_ERROR(inOrder(
      plan.threads, [&] { return blocks.next(); },
      [&](const Block& block, int thread) {
        return (*workers)[std::size_t(thread)]->measure(block, grid, zooms, totals.keepEvery(),
                                                        raster.has_value());
      },
      take));
  totals.finishAll();
  if (raster)
    QMESH_RETURN_IF_ERROR(raster->close());
  return report;
}

} // namespace qmesh
