// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/metadata.h"

#include <gtest/gtest.h>

namespace qmesh {
namespace {

//   zoom 2 (6,1)..(7,2) and (0,0); zoom 3 (13,2) only; nothing at zoom 4
Availability someTiles() {
  Availability set;
  set.add(1, {2, 0, 3, 1});
  set.add(2, {6, 1, 7, 2});
  set.add({2, 0, 0});
  set.add({3, 13, 2});
  return set;
}

TEST(Metadata, ListsTheDescendantsOfATileOnly) {
  EXPECT_EQ(metadataJson(someTiles(), {1, 3, 0}, 3),
            R"({"available":[[{"startX":6,"startY":1,"endX":7,"endY":1}],)"
            R"([{"startX":13,"startY":2,"endX":13,"endY":2}],[]]})");
}

TEST(Metadata, OfARoot) {
  EXPECT_EQ(metadataJson(someTiles(), {0, 1, 0}, 1),
            R"({"available":[[{"startX":2,"startY":0,"endX":3,"endY":1}]]})");
  EXPECT_EQ(metadataJson(someTiles(), {0, 0, 0}, 2),
            R"({"available":[[],[{"startX":0,"startY":0,"endX":0,"endY":0}]]})");
}

TEST(Metadata, HasAListForLevelsBelowTheDeepestZoom) {
  EXPECT_EQ(metadataJson(someTiles(), {kMaxZoom, 5, 5}, 2), R"({"available":[[],[]]})");
  EXPECT_EQ(metadataJson(Availability(), {0, 0, 0}, 0), R"({"available":[]})");
}

} // namespace
} // namespace qmesh
