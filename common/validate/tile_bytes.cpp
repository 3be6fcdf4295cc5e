// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/tile_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "codec/format.h"
#include "codec/gzip.h"
#include "validate/tile_layout.h"

namespace qmesh {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kMaxTile = std::size_t(128) << 20; ///< bytes

/// The work on one file's bytes.
class Reader {
 public:
  Reader(ExtensionLengths lengths, const std::string& place, Findings& findings)
      : lengths_(lengths), place_(place), findings_(findings) {}

  void read(const Bytes& bytes, ReadTile& tile);

 private:
  void add(int code, const std::string& what) { findings_.push_back({code, place_, what}); }
  bool isText(const Bytes& bytes) const;
  bool otherLengths(const Bytes& bytes, TileLayout& layout);
  bool checkVertices(const Bytes& bytes, const TileLayout& layout);
  bool checkIndices(const Bytes& bytes, const TileLayout& layout);
  bool checkEdges(const Bytes& bytes, const TileLayout& layout);
  std::optional<TileLayout> inOtherWidth(const Bytes& bytes, const TileLayout& layout);
  void checkExtensions(const Bytes& bytes, const TileLayout& layout);
  std::optional<TileMesh> mended(Bytes bytes, const TileLayout& layout);

  ExtensionLengths lengths_;
  const std::string& place_;
  Findings& findings_;
};

bool Reader::isText(const Bytes& bytes) const {
  const auto first = std::find_if(bytes.begin(), bytes.end(), [](std::uint8_t c) {
    return c != ' ' && c != '\n' && c != '\r';
  });
  const std::size_t seen = std::min<std::size_t>(bytes.size(), 64);
  const bool printable = std::all_of(bytes.begin(), bytes.begin() + std::ptrdiff_t(seen),
                                     [](std::uint8_t c) { return c >= 9 && c < 127; });
  return first == bytes.end() || (printable && (*first == '<' || *first == '{'));
}

/// True where the indices from highest so far minus code all name vertices.
template <class Index>
bool highWaterMarkFits(const Bytes& bytes, const TileLayout& layout, std::size_t& at) {
  std::uint32_t next = 0;
  for (std::size_t k = 0; k < layout.indices.count; ++k) {
    const std::uint32_t back =
        numberAt(bytes, layout.indices.offset + k * sizeof(Index), int(sizeof(Index)));
    at = k;
    if (back > next || next - back >= layout.vertices.count)
      return false;
    next += back == 0;
  }
  return true;
}

bool indicesFit(const Bytes& bytes, const TileLayout& layout, std::size_t& at) {
  return layout.indexWidth == 2 ? highWaterMarkFits<std::uint16_t>(bytes, layout, at)
                                : highWaterMarkFits<std::uint32_t>(bytes, layout, at);
}

/// The mesh of a tile whose indices have the other width, written anew in the right one.
Bytes inRightWidth(const Bytes& bytes, const TileLayout& layout) {
  const int width = layout.vertices.count > format::kMaxVertices16 ? 4 : 2;
  Bytes out(bytes.begin(),
            bytes.begin() + std::ptrdiff_t(layout.vertices.offset + 6 * layout.vertices.count));
  const auto put = [&](std::size_t value, int size) {
    for (int k = 0; k < size; ++k)
      out.push_back(std::uint8_t(value >> (8 * k)));
  };
  while (out.size() % std::size_t(width) != 0)
    out.push_back(0);
  const auto copy = [&](const TileLayout::Part& part, std::size_t count) {
    put(count, 4);
    for (std::size_t k = 0; k < part.count; ++k)
      put(numberAt(bytes, part.offset + k * std::size_t(layout.indexWidth), layout.indexWidth),
          width);
  };
  copy(layout.indices, layout.indices.count / 3);
  for (const TileLayout::Part& edge : layout.edges)
    copy(edge, edge.count);
  out.insert(out.end(), bytes.begin() + std::ptrdiff_t(layout.extensionsAt), bytes.end());
  return out;
}

bool Reader::checkVertices(const Bytes& bytes, const TileLayout& layout) {
  constexpr const char* kNames[] = {"u", "v", "height"};
  for (std::size_t array = 0; array < 3; ++array) {
    int value = 0;
    for (std::size_t k = 0; k < layout.vertices.count; ++k) {
      const std::size_t at = layout.vertices.offset + 2 * (array * layout.vertices.count + k);
      value += format::unZigZag(std::uint16_t(numberAt(bytes, at, 2)));
      if (value >= 0 && value <= format::kQuantizedMax)
        continue;
      add(205, std::string(kNames[array]) + " of vertex " + std::to_string(k) + " is " +
                   std::to_string(value));
      return false;
    }
  }
  return true;
}

bool Reader::checkIndices(const Bytes& bytes, const TileLayout& layout) {
  std::size_t at = 0;
  if (layout.indices.count == 0) {
    add(204, "there are no triangles");
    return false;
  }
  if (indicesFit(bytes, layout, at))
    return true;
  add(206, "corner " + std::to_string(at % 3) + " of triangle " + std::to_string(at / 3) +
               " names none of the " + std::to_string(layout.vertices.count) + " vertices");
  return false;
}

bool Reader::checkEdges(const Bytes& bytes, const TileLayout& layout) {
  for (const TileLayout::Part& edge : layout.edges)
    for (std::size_t k = 0; k < edge.count; ++k) {
      const std::size_t at = edge.offset + k * std::size_t(layout.indexWidth);
      const std::uint32_t vertex = numberAt(bytes, at, layout.indexWidth);
      if (vertex < layout.vertices.count)
        continue;
      add(208, "an entry names vertex " + std::to_string(vertex) + " of " +
                   std::to_string(layout.vertices.count));
      return false;
    }
  return true;
}

/// The layout with the other width of indices, where it alone makes sense of the file.
std::optional<TileLayout> Reader::inOtherWidth(const Bytes& bytes, const TileLayout& layout) {
  std::size_t at = 0;
  const auto sound = [&](const TileLayout& l) {
    return l.missing.empty() && l.extensionsFit && l.indices.count > 0 && indicesFit(bytes, l, at);
  };
  if (layout.vertices.count == 0 || sound(layout))
    return std::nullopt;
  TileLayout other = tileLayout(bytes, lengths_, 6 - layout.indexWidth);
  return sound(other) ? std::optional<TileLayout>(std::move(other)) : std::nullopt;
}

void Reader::checkExtensions(const Bytes& bytes, const TileLayout& layout) {
  std::vector<int> seen;
  for (const TileLayout::Extension& extension : layout.extensions) {
    const std::string size = std::to_string(extension.size) + " bytes";
    if (std::count(seen.begin(), seen.end(), extension.id) == 1)
      add(215, "extension " + std::to_string(extension.id));
    seen.push_back(extension.id);
    if (extension.size > bytes.size() - std::min(bytes.size(), extension.offset)) {
      add(210, "extension " + std::to_string(extension.id) + " says " + size + ", the file has " +
                   std::to_string(bytes.size() - extension.offset) + " left");
      return;
    }
    if (extension.id == format::kOctNormals && extension.size != 2 * layout.vertices.count)
      add(212, size + " for " + std::to_string(layout.vertices.count) + " vertices");
    else if (extension.id == format::kWaterMask && extension.size != 1 &&
             extension.size != format::kWaterMaskSize)
      add(213, size);
    else if (extension.id == format::kMetadata &&
             (extension.size < 4 || numberAt(bytes, extension.offset, 4) > extension.size - 4))
      add(214, "its text is longer than the extension");
    else if (extension.id != format::kOctNormals && extension.id != format::kWaterMask &&
             extension.id != format::kMetadata)
      add(216, "extension " + std::to_string(extension.id) + ", " + size);
  }
  if (!layout.extensionsFit)
    add(210, "the file ends inside the head of an extension");
}

/// The mesh without what is broken around it: extensions that are at fault, heights of the header
/// that are no numbers.
std::optional<TileMesh> Reader::mended(Bytes bytes, const TileLayout& layout) {
  Bytes good(bytes.begin(), bytes.begin() + std::ptrdiff_t(layout.extensionsAt));
  for (const TileLayout::Extension& extension : layout.extensions) {
    const std::size_t begin = extension.offset - 5, end = extension.offset + extension.size;
    if (end > bytes.size())
      break;
    Bytes with = good;
    with.insert(with.end(), bytes.begin() + std::ptrdiff_t(begin),
                bytes.begin() + std::ptrdiff_t(end));
    if (decodeTile(with.data(), with.size(), lengths_).ok())
      good = std::move(with);
  }
  constexpr std::size_t kHeightsAt = 24; // two float32 numbers
  for (std::size_t at : {kHeightsAt, kHeightsAt + 4}) {
    const std::uint32_t bits = numberAt(good, at, 4);
    float height = 0;
    std::memcpy(&height, &bits, sizeof height);
    if (!std::isfinite(height)) {
      add(401, at == kHeightsAt ? "the least height" : "the greatest height");
      std::fill_n(good.begin() + std::ptrdiff_t(at), 4, std::uint8_t(0));
    }
  }
  Result<TileMesh> mesh = decodeTile(good.data(), good.size(), lengths_);
  return mesh.ok() ? std::optional<TileMesh>(*std::move(mesh)) : std::nullopt;
}

/// Whether the extensions make sense with the other byte order of their lengths only.
bool Reader::otherLengths(const Bytes& bytes, TileLayout& layout) {
  const bool little = lengths_ == ExtensionLengths::littleEndian;
  if (!layout.missing.empty() || layout.extensionsFit || !little)
    return false;
  TileLayout other = tileLayout(bytes, ExtensionLengths::bigEndian);
  if (!other.extensionsFit)
    return false;
  lengths_ = ExtensionLengths::bigEndian;
  layout = std::move(other);
  return true;
}

void Reader::read(const Bytes& bytes, ReadTile& tile) {
  tile.size = bytes.size();
  TileLayout layout = tileLayout(bytes, lengths_);
  if (otherLengths(bytes, layout))
    add(211, std::to_string(layout.extensions.size()) + " extensions");
  Result<TileMesh> mesh = decodeTile(bytes.data(), bytes.size(), lengths_);
  const auto name = [&](const TileLayout& l) {
    for (const TileLayout::Extension& extension : l.extensions)
      tile.extensions.push_back(extension.id);
  };
  if (mesh.ok()) {
    name(layout);
    tile.mesh = *std::move(mesh);
    checkExtensions(bytes, layout);
    return;
  }
  if (layout.missing == "header" && isText(bytes)) {
    add(202, bytes.empty() ? "it is empty" : "it holds text");
    return;
  }
  if (const auto other = inOtherWidth(bytes, layout)) {
    add(207, std::to_string(8 * other->indexWidth) + " bits for " +
                 std::to_string(other->vertices.count) + " vertices");
    const Bytes right = inRightWidth(bytes, *other);
    name(*other);
    if (checkVertices(bytes, *other))
      tile.mesh = mended(right, tileLayout(right, lengths_));
    return;
  }
  if (layout.missing == "header" || layout.missing == "vertices" || layout.vertices.count == 0) {
    add(204, layout.missing.empty() ? "there are no vertices" : "it ends in its " + layout.missing);
    return;
  }
  name(layout);
  const bool vertices = checkVertices(bytes, layout);
  if (!layout.missing.empty()) {
    add(204, "it ends in its " + layout.missing);
    return;
  }
  const bool indices = checkIndices(bytes, layout);
  const bool edges = checkEdges(bytes, layout);
  checkExtensions(bytes, layout);
  if (vertices && indices && edges)
    tile.mesh = mended(bytes, layout);
}

} // namespace

ReadTile readTileBytes(const Bytes& stored, ExtensionLengths lengths, const std::string& place,
                       Findings& findings) {
  ReadTile tile;
  tile.compressed = isGzip(stored.data(), stored.size());
  Reader reader(lengths, place, findings);
  if (!tile.compressed) {
    reader.read(stored, tile);
    return tile;
  }
  Result<Bytes> bytes = gunzip(stored.data(), stored.size(), kMaxTile);
  if (bytes.ok() && isGzip(bytes->data(), bytes->size())) {
    Result<Bytes> twice = gunzip(bytes->data(), bytes->size(), kMaxTile);
    if (twice.ok()) {
      findings.push_back({203, place, std::to_string(stored.size()) + " bytes"});
      bytes = std::move(twice);
    }
  }
  if (!bytes.ok()) {
    findings.push_back({201, place, bytes.status().message()});
    return tile;
  }
  reader.read(*bytes, tile);
  return tile;
}

} // namespace qmesh
