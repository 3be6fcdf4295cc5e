// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/decode.h"

#include <cmath>
#include <cstring>

#include "codec/format.h"

namespace qmesh {
namespace {

constexpr std::size_t kMaxTile = std::size_t(1) << 31; ///< bytes

/// Takes little-endian numbers from a buffer. Whoever takes asks has() first.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : begin_(data), next_(data), left_(size) {}

  std::size_t left() const { return left_; }
  bool has(std::size_t size) const { return size <= left_; }
  /// True where the buffer still holds `count` things of `size` bytes.
  bool has(std::size_t count, std::size_t size) const { return count <= left_ / size; }
  std::size_t position() const { return std::size_t(next_ - begin_); }

  const std::uint8_t* take(std::size_t size) {
    const std::uint8_t* taken = next_;
    next_ += size;
    left_ -= size;
    return taken;
  }

  template <class T> T take() {
    const std::uint8_t* bytes = take(sizeof(T));
    T value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      value = T(value | T(bytes[i]) << (8 * i));
    return value;
  }

  /// A floating-point number, by way of the whole number that has its bits.
  template <class Real, class Bits> Real takeReal() {
    static_assert(sizeof(Real) == sizeof(Bits));
    const Bits bits = take<Bits>();
    Real value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  float takeFloat() { return takeReal<float, std::uint32_t>(); }
  double takeDouble() { return takeReal<double, std::uint64_t>(); }
  Vec3 takeVec3() {
    const double x = takeDouble();
    const double y = takeDouble();
    return {x, y, takeDouble()};
  }

 private:
  const std::uint8_t* begin_;
  const std::uint8_t* next_;
  std::size_t left_;
};

Status fault(const std::string& what) {
  return {Code::input, "The quantized-mesh tile is broken: " + what + "."};
}

Status readHeader(ByteReader& in, TileHeader& header) {
  if (!in.has(format::kHeaderSize))
    return fault("it ends inside its header");
  header.centre = in.takeVec3();
  header.minHeight = in.takeFloat();
  header.maxHeight = in.takeFloat();
  header.sphere.centre = in.takeVec3();
  header.sphere.radius = in.takeDouble();
  header.horizon = in.takeVec3();
  if (!std::isfinite(header.minHeight) || !std::isfinite(header.maxHeight))
    return fault("its least or greatest height is not a number");
  return {};
}

/// One array of `count` values, each stored as its difference from the one before.
Status readDifferences(ByteReader& in, std::size_t count, std::vector<std::uint16_t>& values) {
  values.resize(count);
  int value = 0;
  for (std::uint16_t& stored : values) {
    value += format::unZigZag(in.take<std::uint16_t>());
    if (value < 0 || value > format::kQuantizedMax)
      return fault("a position or height is outside 0..32767");
    stored = std::uint16_t(value);
  }
  return {};
}

Status readVertices(ByteReader& in, TileMesh& mesh) {
  if (!in.has(4))
    return fault("it ends before its vertices");
  const std::size_t count = in.take<std::uint32_t>();
  if (count == 0)
    return fault("it has no vertices");
  if (!in.has(count, 3 * sizeof(std::uint16_t)))
    return fault("it ends inside its " + std::to_string(count) + " vertices");
  QMESH_RETURN_IF_ERROR(readDifferences(in, count, mesh.u));
  QMESH_RETURN_IF_ERROR(readDifferences(in, count, mesh.v));
  return readDifferences(in, count, mesh.q);
}

template <class Index> Status readTriangles(ByteReader& in, TileMesh& mesh) {
  if (!in.has(4))
    return fault("it ends before its triangles");
  const std::size_t count = in.take<std::uint32_t>();
  if (count == 0)
    return fault("it has no triangles");
  if (!in.has(count, 3 * sizeof(Index)))
    return fault("it ends inside its " + std::to_string(count) + " triangles");
  mesh.indices.resize(3 * count);
  std::uint32_t next = 0; // the vertex not yet used, which indices are counted back from
  for (std::uint32_t& index : mesh.indices) {
    const std::uint32_t back = in.take<Index>();
    if (back > next || next - back >= mesh.vertexCount())
      return fault("a triangle names a vertex that does not exist");
    index = next - back;
    next += back == 0;
  }
  return {};
}

template <class Index>
Status readEdge(ByteReader& in, std::size_t vertexCount, std::vector<std::uint32_t>& edge) {
  if (!in.has(4))
    return fault("it ends before an edge list");
  const std::size_t count = in.take<std::uint32_t>();
  if (!in.has(count, sizeof(Index)))
    return fault("it ends inside an edge list");
  edge.resize(count);
  for (std::uint32_t& index : edge) {
    index = in.take<Index>();
    if (index >= vertexCount)
      return fault("an edge list names a vertex that does not exist");
  }
  return {};
}

template <class Index> Status readIndices(ByteReader& in, TileMesh& mesh) {
  const std::size_t padding = (sizeof(Index) - in.position() % sizeof(Index)) % sizeof(Index);
  if (!in.has(padding))
    return fault("it ends before its triangles");
  in.take(padding);
  QMESH_RETURN_IF_ERROR(readTriangles<Index>(in, mesh));
  for (auto& edge : mesh.edges)
    QMESH_RETURN_IF_ERROR(readEdge<Index>(in, mesh.vertexCount(), edge));
  return {};
}

Status readMetadata(ByteReader extension, std::string& text) {
  if (!extension.has(4))
    return fault("it ends inside its metadata extension");
  const std::size_t size = extension.take<std::uint32_t>();
  if (!extension.has(size))
    return fault("the text of its metadata extension is longer than the extension");
  const std::uint8_t* data = extension.take(size);
  text.assign(data, data + size);
  return {};
}

Status readExtension(std::uint8_t id, const std::uint8_t* data, std::size_t size, TileMesh& mesh) {
  switch (id) {
  case format::kOctNormals:
    if (size != 2 * mesh.vertexCount())
      return fault("its normals are not two bytes for each vertex");
    mesh.extensions.normals.assign(data, data + size);
    return {};
  case format::kWaterMask:
    if (size != 1 && size != format::kWaterMaskSize)
      return fault("its water mask has neither 1 nor 65536 bytes");
    mesh.extensions.waterMask.assign(data, data + size);
    return {};
  case format::kMetadata:
    return readMetadata(ByteReader(data, size), mesh.extensions.metadata);
  default:
    return {}; // one that we do not know
  }
}

std::uint32_t swapped(std::uint32_t x) {
  return x >> 24 | (x >> 8 & 0xff00) | (x << 8 & 0xff0000) | x << 24;
}

Status readExtensions(ByteReader& in, ExtensionLengths lengths, TileMesh& mesh) {
  while (in.left() > 0) {
    if (!in.has(5))
      return fault("it ends inside the head of an extension");
    const std::uint8_t id = in.take<std::uint8_t>();
    const std::uint32_t stored = in.take<std::uint32_t>();
    const std::size_t size = lengths == ExtensionLengths::bigEndian ? swapped(stored) : stored;
    if (!in.has(size))
      return fault("it ends inside extension " + std::to_string(id));
    QMESH_RETURN_IF_ERROR(readExtension(id, in.take(size), size, mesh));
  }
  return {};
}

} // namespace

Result<TileMesh> decodeTile(const std::uint8_t* data, std::size_t size, ExtensionLengths lengths) {
  if (size > kMaxTile)
    return fault("it is larger than 2 GB");
  TileMesh mesh;
  ByteReader in(data, size);
  QMESH_RETURN_IF_ERROR(readHeader(in, mesh.header));
  QMESH_RETURN_IF_ERROR(readVertices(in, mesh));
  if (mesh.vertexCount() > format::kMaxVertices16)
    QMESH_RETURN_IF_ERROR(readIndices<std::uint32_t>(in, mesh));
  else
    QMESH_RETURN_IF_ERROR(readIndices<std::uint16_t>(in, mesh));
  QMESH_RETURN_IF_ERROR(readExtensions(in, lengths, mesh));
  return mesh;
}

} // namespace qmesh
