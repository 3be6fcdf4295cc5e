// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "pyramid/blocks/chunk_store.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "codec/gzip.h"

namespace qmesh {

namespace {

/// Fast rather than small: the file lives for minutes.
constexpr int kSpillCompression = 1;

std::uint64_t keyOf(std::uint32_t x, std::uint32_t y) {
  return std::uint64_t(y) << 32 | x;
}

Status fileError(const std::string& file, const char* what) {
  return {Code::output, file + ": cannot " + what + " the temporary file: " + std::strerror(errno)};
}

/// Copies the part of a chunk that lies in the window; the chunk's place is given in the window's
/// own, unwrapped columns.
void copyIntoWindow(const std::vector<float>& nodes, std::int64_t edge, std::int64_t column,
                    std::int64_t row, NodeWindow& window) {
  const std::int64_t first = std::max(column, window.column0());
  const std::int64_t end = std::min(column + edge, window.column0() + window.width());
  const std::int64_t firstRow = std::max(row, window.row0());
  const std::int64_t endRow = std::min(row + edge, window.row0() + window.height());
  if (first >= end)
    return;
  for (std::int64_t j = firstRow; j < endRow; ++j) {
    const float* from = nodes.data() + (j - row) * edge + (first - column);
    std::copy(from, from + (end - first),
              window.row(int(j - window.row0())) + (first - window.column0()));
  }
}

} // namespace

ChunkStore::ChunkStore(const NodeLattice& lattice, MemoryBudget& budget, std::string spillFile)
    : lattice_(lattice), budget_(budget), spillFile_(std::move(spillFile)) {}

ChunkStore::~ChunkStore() {
  for (const auto& entry : chunks_) {
    budget_ += std::int64_t(entry.second.nodes.size() * sizeof(float));
  }
  if (file_ >= 0) {
    close(file_);
    unlink(spillFile_.c_str());
  }
}

std::size_t ChunkStore::chunkNodes() const {
  const std::size_t edge = std::size_t(lattice_.cells()) + 1;
  return edge * edge;
}

Status ChunkStore::openSpillFile() {
  if (file_ >= 0)
    return {};
  file_ = open(spillFile_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  return file_ >= 0 ? Status() : fileError(spillFile_, "create");
}

Status ChunkStore::spill(const std::vector<float>& nodes, Chunk& chunk) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(nodes.data());
  const std::vector<std::uint8_t> packed =
      GzipCompressor(kSpillCompression)
          .compress(std::vector<std::uint8_t>(bytes, bytes + nodes.size() * sizeof(float)));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    QMESH_RETURN_IF_ERROR(openSpillFile());
    chunk.offset = fileSize_;
    fileSize_ += packed.size();
  }
  chunk.size = std::uint32_t(packed.size());
  for (std::size_t done = 0; done < packed.size();) {
    const ssize_t n =
        pwrite(file_, packed.data() + done, packed.size() - done, off_t(chunk.offset + done));
    if (n <= 0)
      return fileError(spillFile_, "write");
    done += std::size_t(n);
  }
  return {};
}

Status ChunkStore::load(const Chunk& chunk, std::vector<float>& nodes) const {
  std::vector<std::uint8_t> packed(chunk.size);
  for (std::size_t done = 0; done < packed.size();) {
    const ssize_t n =
        pread(file_, packed.data() + done, packed.size() - done, off_t(chunk.offset + done));
    if (n <= 0)
      return fileError(spillFile_, "read");
    done += std::size_t(n);
  }
  const std::size_t size = chunkNodes() * sizeof(float);
  const auto bytes = gunzip(packed.data(), packed.size(), size);
  if (!bytes.ok())
    return bytes.status();
  if (bytes->size() != size)
    return {Code::internal, spillFile_ + ": a chunk has the wrong size"};
  nodes.resize(chunkNodes());
  std::memcpy(nodes.data(), bytes->data(), size);
  return {};
}

Status ChunkStore::put(const NodeWindow& window, TileId tile) {
  const int n = lattice_.cells();
  const std::int64_t a = std::int64_t(tile.x) * n - window.column0();
  const std::int64_t b = std::int64_t(tile.y) * n - window.row0();
  std::vector<float> nodes(chunkNodes());
  for (int j = 0; j <= n; ++j) {
    const float* row = window.row(int(b + j)) + a;
    std::copy(row, row + n + 1, nodes.data() + std::ptrdiff_t(j) * (n + 1));
  }
  if (std::all_of(nodes.begin(), nodes.end(), [](float h) { return std::isnan(h); }))
    return {};
  Chunk chunk;
  const std::int64_t size = std::int64_t(nodes.size() * sizeof(float));
  if (budget_.fetch_sub(size) >= size) {
    chunk.nodes = std::move(nodes);
  } else {
    budget_ += size;
    QMESH_RETURN_IF_ERROR(spill(nodes, chunk));
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  chunks_[keyOf(tile.x, tile.y)] = std::move(chunk);
  return {};
}

Status ChunkStore::read(NodeWindow& window) const {
  const std::int64_t n = lattice_.cells();
  const std::int64_t columns = lattice_.columns() / n;
  const std::int64_t rows = lattice_.lastRow() / n;
  const auto tileOf = [n](std::int64_t node) { return (node >= 0 ? node : node - n + 1) / n; };
  // A node on a tile's west or south edge is held by the tile before it, too.
  const std::int64_t y0 = std::max<std::int64_t>(0, tileOf(window.row0() - 1));
  const std::int64_t y1 = std::min(rows - 1, tileOf(window.row0() + window.height() - 1));
  const std::int64_t x0 = tileOf(window.column0() - 1);
  const std::int64_t x1 = tileOf(window.column0() + window.width() - 1);
  std::vector<float> scratch;
  for (std::int64_t y = y0; y <= y1; ++y) {
    for (std::int64_t x = x0; x <= x1; ++x) {
      const std::int64_t wrapped = ((x % columns) + columns) % columns;
      const auto found = chunks_.find(keyOf(std::uint32_t(wrapped), std::uint32_t(y)));
      if (found == chunks_.end())
        continue;
      const Chunk& chunk = found->second;
      if (chunk.nodes.empty())
        QMESH_RETURN_IF_ERROR(load(chunk, scratch));
      copyIntoWindow(chunk.nodes.empty() ? scratch : chunk.nodes, n + 1, x * n, y * n, window);
    }
  }
  return {};
}

} // namespace qmesh
