// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/tile_layout.h"

#include "codec/format.h"

namespace qmesh {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr const char* kEdgeNames[] = {"west", "south", "east", "north"};

/// Goes over the bytes part by part.
class Walker {
 public:
  Walker(const Bytes& bytes, TileLayout& layout) : bytes_(bytes), layout_(layout) {}

  bool skip(std::size_t count, std::size_t size, const char* part) {
    if (count > (bytes_.size() - at_) / size) {
      layout_.missing = part;
      return false;
    }
    at_ += count * size;
    return true;
  }

  /// A count, and the list of `size` bytes each that follows it.
  bool list(TileLayout::Part& part, std::size_t size, std::size_t perCount, const char* name) {
    if (bytes_.size() - at_ < 4) {
      layout_.missing = name;
      return false;
    }
    part.count = numberAt(bytes_, at_, 4);
    part.offset = at_ += 4;
    if (part.count > bytes_.size() / (size * perCount)) {
      layout_.missing = name;
      return false;
    }
    part.count *= perCount;
    return skip(part.count, size, name);
  }

  std::size_t at() const { return at_; }

 private:
  const Bytes& bytes_;
  TileLayout& layout_;
  std::size_t at_ = 0;
};

std::uint32_t lengthAt(const Bytes& bytes, std::size_t at, ExtensionLengths lengths) {
  if (lengths == ExtensionLengths::littleEndian)
    return numberAt(bytes, at, 4);
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value = value << 8 | bytes[at + k];
  return value;
}

void findExtensions(const Bytes& bytes, ExtensionLengths lengths, TileLayout& layout) {
  constexpr std::size_t kHead = 5;
  std::size_t at = layout.extensionsAt;
  while (at < bytes.size() && layout.extensionsFit) {
    layout.extensionsFit = bytes.size() - at >= kHead;
    if (!layout.extensionsFit)
      return;
    const std::size_t size = lengthAt(bytes, at + 1, lengths);
    layout.extensionsFit = size <= bytes.size() - at - kHead;
    layout.extensions.push_back({bytes[at], at + kHead, size});
    at += kHead + size;
  }
}

} // namespace

std::uint32_t numberAt(const Bytes& bytes, std::size_t offset, int width) {
  std::uint32_t value = 0;
  for (int k = width - 1; k >= 0; --k)
    value = value << 8 | bytes[offset + std::size_t(k)];
  return value;
}

TileLayout tileLayout(const Bytes& bytes, ExtensionLengths lengths, int indexWidth) {
  TileLayout layout;
  Walker walker(bytes, layout);
  if (!walker.skip(1, format::kHeaderSize, "header") ||
      !walker.list(layout.vertices, 2, 3, "vertices"))
    return layout;
  layout.vertices.count /= 3;
  const bool wide = layout.vertices.count > format::kMaxVertices16;
  layout.indexWidth = indexWidth > 0 ? indexWidth : wide ? 4 : 2;
  const auto width = std::size_t(layout.indexWidth);
  if (!walker.skip((width - walker.at() % width) % width, 1, "triangles") ||
      !walker.list(layout.indices, width, 3, "triangles"))
    return layout;
  for (std::size_t k = 0; k < 4; ++k)
    if (!walker.list(layout.edges[k], width, 1, kEdgeNames[k])) {
      layout.missing += " edge list";
      return layout;
    }
  layout.extensionsAt = walker.at();
  findExtensions(bytes, lengths, layout);
  return layout;
}

} // namespace qmesh
