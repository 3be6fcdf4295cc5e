// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/metadata.h"

#include <gtest/gtest.h>

namespace qmesh {
namespace {

TEST(Metadata, ListsRectanglesByLevel) {
  EXPECT_EQ(metadataJson({{{6, 1, 7, 1}}, {{13, 2, 13, 2}, {0, 3, 1, 3}}, {}}),
            R"({"available":[[{"startX":6,"startY":1,"endX":7,"endY":1}],)"
            R"([{"startX":13,"startY":2,"endX":13,"endY":2},)"
            R"({"startX":0,"startY":3,"endX":1,"endY":3}],[]]})");
}

TEST(Metadata, OfATileWithoutDescendants) {
  EXPECT_EQ(metadataJson({{}, {}}), R"({"available":[[],[]]})");
  EXPECT_EQ(metadataJson({}), R"({"available":[]})");
}

TEST(Metadata, IsReadBack) {
  const std::vector<std::vector<TileRange>> levels = {{{6, 1, 7, 1}}, {}, {{28, 5, 28, 7}}};
  const auto read = readMetadataJson(metadataJson(levels), Scheme(Profile::geodetic), {1, 3, 0});
  ASSERT_TRUE(read.ok()) << read.status().message();
  EXPECT_EQ(levels, *read);
}

} // namespace
} // namespace qmesh
