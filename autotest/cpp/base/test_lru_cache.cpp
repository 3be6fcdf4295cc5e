// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "base/lru_cache.h"

#include <gtest/gtest.h>

namespace qmesh {
namespace {

TEST(LruCache, TheOneNotAskedForTheLongestGoes) {
  LruCache<int, char> cache(10);
  cache.put(1, 'a', 4);
  cache.put(2, 'b', 4);
  ASSERT_TRUE(cache.find(1));
  cache.put(3, 'c', 4);
  EXPECT_EQ(cache.find(2), nullptr);
  ASSERT_TRUE(cache.find(1) && cache.find(3));
  EXPECT_EQ(*cache.find(1), 'a');
  EXPECT_EQ(cache.used(), 8u);
}

TEST(LruCache, OneThatIsTooLargeIsAlone) {
  LruCache<int, char> cache(10);
  cache.put(1, 'a', 4);
  cache.put(2, 'b', 40);
  EXPECT_EQ(cache.find(1), nullptr);
  EXPECT_TRUE(cache.find(2));
  cache.put(3, 'c', 1);
  EXPECT_EQ(cache.find(2), nullptr);
  EXPECT_EQ(cache.used(), 1u);
}

} // namespace
} // namespace qmesh
