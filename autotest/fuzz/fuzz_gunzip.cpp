// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/gzip.h"
#include "require.h"

/// Any bytes: unpacking keeps its limit, and packing the result unpacks to the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kLimit = 1 << 20;
  const auto text = qmesh::gunzip(data, size, kLimit);
  if (!text.ok())
    return 0;
  using qmesh::fuzz::require;
  require(qmesh::isGzip(data, size), "only gzip is unpacked");
  require(text->size() <= kLimit, "no more bytes than allowed");
  const auto packed = qmesh::GzipCompressor().compress(*text);
  const auto again = qmesh::gunzip(packed.data(), packed.size(), kLimit);
  require(again.ok() && *again == *text, "unpacking what was packed gives the bytes back");
  return 0;
}
