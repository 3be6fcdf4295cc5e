// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/gzip.h"

#include <algorithm>
#include <cassert>
#include <new>

#ifdef QMESH_HAVE_LIBDEFLATE
#include <libdeflate.h>
#else
#include <zlib.h>
#endif

namespace qmesh {
namespace {

/// Shortest member: header, empty block, checksum, size.
constexpr std::size_t kLeastMember = 10 + 2 + 8;

/// No deflate stream grows by more than this when it is unpacked.
constexpr std::size_t kMostGrowth = 1032;

Status broken(const char* what) {
  return {Code::input, std::string("The gzip data cannot be used: ") + what + "."};
}

/// The size of the unpacked data modulo 2^32, which the member ends with.
std::size_t statedSize(const std::uint8_t* data, std::size_t size) {
  const std::uint8_t* p = data + size - 4;
  return std::size_t(p[0]) | std::size_t(p[1]) << 8 | std::size_t(p[2]) << 16 |
         std::size_t(p[3]) << 24;
}

} // namespace

bool isGzip(const std::uint8_t* data, std::size_t size) {
  return size >= 3 && data[0] == 0x1f && data[1] == 0x8b && data[2] == 8;
}

#ifdef QMESH_HAVE_LIBDEFLATE

struct GzipCompressor::Impl {
  libdeflate_compressor* const state;
  std::vector<std::uint8_t> room;

  explicit Impl(int level) : state(libdeflate_alloc_compressor(level)) {
    if (!state)
      throw std::bad_alloc();
  }
  ~Impl() { libdeflate_free_compressor(state); }

  /// Into room; the number of bytes.
  std::size_t run(const std::vector<std::uint8_t>& bytes) {
    room.resize(std::max(room.size(), libdeflate_gzip_compress_bound(state, bytes.size())));
    return libdeflate_gzip_compress(state, bytes.data(), bytes.size(), room.data(), room.size());
  }
};

namespace {

/// True where the member fills `out` exactly and ends where the input ends.
bool unpack(const std::uint8_t* data, std::size_t size, std::uint8_t* out, std::size_t outSize) {
  libdeflate_decompressor* state = libdeflate_alloc_decompressor();
  if (!state)
    throw std::bad_alloc();
  std::size_t used = 0;
  const libdeflate_result result =
      libdeflate_gzip_decompress_ex(state, data, size, out, outSize, &used, nullptr);
  libdeflate_free_decompressor(state);
  return result == LIBDEFLATE_SUCCESS && used == size;
}

} // namespace

#else

struct GzipCompressor::Impl {
  z_stream state{};
  std::vector<std::uint8_t> room;

  explicit Impl(int level) {
    constexpr int kGzipWindow = 15 + 16, kMemory = 8;
    if (deflateInit2(&state, level, Z_DEFLATED, kGzipWindow, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Impl() { deflateEnd(&state); }

  /// Into room; the number of bytes.
  std::size_t run(const std::vector<std::uint8_t>& bytes) {
    deflateReset(&state);
    room.resize(std::max(room.size(), std::size_t(deflateBound(&state, uLong(bytes.size())))));
    state.next_in = const_cast<Bytef*>(bytes.data());
    state.avail_in = uInt(bytes.size());
    state.next_out = room.data();
    state.avail_out = uInt(room.size());
    return deflate(&state, Z_FINISH) == Z_STREAM_END ? state.total_out : 0;
  }
};

namespace {

/// True where the member fills `out` exactly and ends where the input ends.
bool unpack(const std::uint8_t* data, std::size_t size, std::uint8_t* out, std::size_t outSize) {
  z_stream state{};
  constexpr int kGzipWindow = 15 + 16;
  if (inflateInit2(&state, kGzipWindow) != Z_OK)
    throw std::bad_alloc();
  state.next_in = const_cast<Bytef*>(data);
  state.avail_in = uInt(size);
  state.next_out = out;
  state.avail_out = uInt(outSize);
  const int result = inflate(&state, Z_FINISH);
  const bool whole = result == Z_STREAM_END && state.avail_in == 0 && state.avail_out == 0;
  inflateEnd(&state);
  return whole;
}

} // namespace

#endif

GzipCompressor::GzipCompressor(int level) : impl_(std::make_unique<Impl>(level)) {}
GzipCompressor::~GzipCompressor() = default;

std::vector<std::uint8_t> GzipCompressor::compress(const std::vector<std::uint8_t>& bytes) {
  const std::size_t size = impl_->run(bytes);
  assert(size > 0);
  return {impl_->room.begin(), impl_->room.begin() + std::ptrdiff_t(size)};
}

Result<std::vector<std::uint8_t>> gunzip(const std::uint8_t* data, std::size_t size,
                                         std::size_t maxSize) {
  constexpr std::size_t kLimit = std::size_t(1) << 31;
  if (!isGzip(data, size))
    return broken("it does not begin like gzip");
  if (size < kLeastMember || size > kLimit)
    return broken("it is cut off or too large");
  // What a tile unpacks to is known beforehand, so one buffer of just that size will do; a wrong
  // size at the end of the member fails like a wrong checksum.
  const std::size_t outSize = statedSize(data, size);
  if (outSize > std::min(maxSize, kLimit))
    return broken("it unpacks to more than the limit");
  if (outSize / kMostGrowth > size)
    return broken("the size at its end is wrong");
  std::vector<std::uint8_t> out(std::max<std::size_t>(outSize, 1));
  if (!unpack(data, size, out.data(), outSize))
    return broken("it is damaged, cut off or followed by other data");
  out.resize(outSize);
  return out;
}

} // namespace qmesh
