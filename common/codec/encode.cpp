// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/encode.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "codec/format.h"

namespace qmesh {
namespace {

/// Appends little-endian numbers to a buffer whose room was reckoned beforehand.
class ByteWriter {
 public:
  explicit ByteWriter(std::size_t size) : bytes_(size), next_(bytes_.data()) {}

  template <class T> void put(T value) {
    static_assert(std::is_unsigned_v<T>);
    std::uint8_t* const to = next_; // a local, which the bytes written cannot alias
    for (std::size_t i = 0; i < sizeof(T); ++i)
      to[i] = std::uint8_t(value >> (8 * i));
    next_ = to + sizeof(T);
  }

  void put(float value) {
    std::uint32_t bits;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    put(bits);
  }

  void put(double value) {
    std::uint64_t bits;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    put(bits);
  }

  void put(const Vec3& v) {
    put(v.x);
    put(v.y);
    put(v.z);
  }

  void copy(const void* from, std::size_t size) {
    std::memcpy(next_, from, size);
    next_ += size;
  }

  std::size_t size() const { return std::size_t(next_ - bytes_.data()); }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
  std::uint8_t* next_;
};

Status fault(const char* what) {
  return {Code::internal, std::string("A tile cannot be encoded: ") + what + "."};
}

bool inRange(const std::vector<std::uint16_t>& values) {
  std::uint16_t bits = 0;
  for (const std::uint16_t value : values)
    bits |= value;
  return bits <= format::kQuantizedMax; // all ones, so one comparison does for all
}

Status checkVertices(const TileMesh& mesh) {
  const std::size_t count = mesh.vertexCount();
  if (mesh.v.size() != count || mesh.q.size() != count)
    return fault("its vertex arrays differ in length");
  if (count == format::kAmbiguousVertices)
    return fault("clients misread tiles of exactly 65536 vertices");
  if (!inRange(mesh.u) || !inRange(mesh.v) || !inRange(mesh.q))
    return fault("a position or height is above 32767");
  if (!mesh.extensions.normals.empty() && mesh.extensions.normals.size() != 2 * count)
    return fault("it does not have two bytes of normal for each vertex");
  return {};
}

Status checkMesh(const TileMesh& mesh) {
  QMESH_RETURN_IF_ERROR(checkVertices(mesh));
  if (mesh.indices.empty() || mesh.indices.size() % 3 != 0)
    return fault("it has no whole number of triangles");
  for (const auto& edge : mesh.edges)
    for (const std::uint32_t index : edge)
      if (index >= mesh.vertexCount())
        return fault("an edge names a vertex that does not exist");
  const std::size_t mask = mesh.extensions.waterMask.size();
  if (mask > 1 && mask != format::kWaterMaskSize)
    return fault("its water mask has neither 1 nor 65536 bytes");
  return {};
}

/// An upper bound that is exact but for the padding.
std::size_t encodedSize(const TileMesh& mesh) {
  constexpr std::size_t kCount = 4, kExtensionHead = 5, kPadding = 2;
  const std::size_t indexSize = mesh.vertexCount() > format::kMaxVertices16 ? 4 : 2;
  std::size_t size = format::kHeaderSize + kCount + 6 * mesh.vertexCount() + kPadding;
  size += kCount + indexSize * mesh.indices.size();
  for (const auto& edge : mesh.edges)
    size += kCount + indexSize * edge.size();
  size += 2 * kExtensionHead + mesh.extensions.normals.size() + mesh.extensions.waterMask.size();
  size += kExtensionHead + kCount + mesh.extensions.metadata.size();
  return size;
}

void putHeader(ByteWriter& out, const TileHeader& header) {
  out.put(header.centre);
  out.put(header.minHeight);
  out.put(header.maxHeight);
  out.put(header.sphere.centre);
  out.put(header.sphere.radius);
  out.put(header.horizon);
}

void putDifferences(ByteWriter& out, const std::vector<std::uint16_t>& values) {
  int last = 0;
  for (const std::uint16_t value : values) {
    out.put(format::zigZag(value - last));
    last = value;
  }
}

/// Each index as its distance from the next vertex not yet used. False where the vertices are not
/// all used, or not in the order of first use, which this coding cannot express.
template <class Index> bool putTriangles(ByteWriter& out, const TileMesh& mesh) {
  out.put(std::uint32_t(mesh.triangleCount()));
  std::uint32_t next = 0;
  bool inOrder = true;
  for (const std::uint32_t index : mesh.indices) {
    out.put(Index(next - index));
    inOrder &= index <= next;
    next += index == next;
  }
  return inOrder && next == mesh.vertexCount();
}

template <class Index> bool putIndices(ByteWriter& out, const TileMesh& mesh) {
  while (out.size() % sizeof(Index) != 0)
    out.put(std::uint8_t(0));
  const bool inOrder = putTriangles<Index>(out, mesh);
  for (const auto& edge : mesh.edges) {
    out.put(std::uint32_t(edge.size()));
    for (const std::uint32_t index : edge)
      out.put(Index(index));
  }
  return inOrder;
}

void putExtensionHead(ByteWriter& out, format::Extension id, std::size_t size) {
  out.put(std::uint8_t(id));
  out.put(std::uint32_t(size));
}

void putExtensions(ByteWriter& out, const TileMesh& mesh) {
  if (!mesh.extensions.normals.empty()) {
    putExtensionHead(out, format::kOctNormals, mesh.extensions.normals.size());
    out.copy(mesh.extensions.normals.data(), mesh.extensions.normals.size());
  }
  if (!mesh.extensions.waterMask.empty()) {
    putExtensionHead(out, format::kWaterMask, mesh.extensions.waterMask.size());
    out.copy(mesh.extensions.waterMask.data(), mesh.extensions.waterMask.size());
  }
  if (!mesh.extensions.metadata.empty()) {
    // The text carries a length of its own inside the extension.
    putExtensionHead(out, format::kMetadata, 4 + mesh.extensions.metadata.size());
    out.put(std::uint32_t(mesh.extensions.metadata.size()));
    out.copy(mesh.extensions.metadata.data(), mesh.extensions.metadata.size());
  }
}

} // namespace

Result<std::vector<std::uint8_t>> encodeTile(const TileMesh& mesh) {
  QMESH_RETURN_IF_ERROR(checkMesh(mesh));
  ByteWriter out(encodedSize(mesh));
  putHeader(out, mesh.header);
  out.put(std::uint32_t(mesh.vertexCount()));
  putDifferences(out, mesh.u);
  putDifferences(out, mesh.v);
  putDifferences(out, mesh.q);
  const bool inOrder = mesh.vertexCount() > format::kMaxVertices16
                           ? putIndices<std::uint32_t>(out, mesh)
                           : putIndices<std::uint16_t>(out, mesh);
  if (!inOrder)
    return fault("its vertices are not in the order of first use, or not all used");
  putExtensions(out, mesh);
  const std::size_t size = out.size();
  std::vector<std::uint8_t> bytes = out.take();
  bytes.resize(size);
  return bytes;
}

} // namespace qmesh
