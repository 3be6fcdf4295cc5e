// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/finding.h"

#include <gtest/gtest.h>

namespace qmesh {
namespace {

TEST(Finding, TableIsSortedAndComplete) {
  int last = 100;
  for (const FindingKind& kind : findingKinds()) {
    EXPECT_GT(kind.code, last);
    last = kind.code;
    EXPECT_STRNE(enumName(kind.group()), "") << kind.code;
    for (const std::string text : {kind.explanation, kind.cure}) {
      ASSERT_FALSE(text.empty()) << kind.code;
      EXPECT_EQ(text.back(), '.') << kind.code;
    }
    const std::string title = kind.title;
    ASSERT_FALSE(title.empty()) << kind.code;
    EXPECT_NE(title.back(), '.') << kind.code;
    EXPECT_EQ(&findingKind(kind.code), &kind);
    EXPECT_EQ(codeOf(codeText(kind.code)), kind.code);
  }
}

TEST(Finding, CodesAreReadInAnyForm) {
  EXPECT_EQ(codeOf("QM601"), 601);
  EXPECT_EQ(codeOf("qm601"), 601);
  EXPECT_EQ(codeOf("601"), 601);
  EXPECT_EQ(codeOf("QM999"), 0);
  EXPECT_EQ(codeOf(""), 0);
  EXPECT_EQ(codeOf("QM"), 0);
}

} // namespace
} // namespace qmesh
