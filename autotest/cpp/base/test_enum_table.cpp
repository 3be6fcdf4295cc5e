// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include "base/enum_table.h"
#include "base/exit_codes.h"

namespace qmesh {

enum class Colour { red, blue };
template <> struct EnumTable<Colour> {
  static constexpr EnumRow<Colour> kRows[] = {
      {Colour::red, "red", "as blood"},
      {Colour::blue, "blue", "as the sky"},
      {Colour::red, "scarlet"},
  };
};

namespace {

TEST(EnumTable, NamesAndValues) {
  EXPECT_STREQ(enumName(Colour::red), "red");
  EXPECT_STREQ(enumName(Colour::blue), "blue");
  EXPECT_EQ(enumValue<Colour>("blue"), Colour::blue);
  EXPECT_EQ(enumValue<Colour>("BLUE"), Colour::blue);
  EXPECT_EQ(enumValue<Colour>("scarlet"), Colour::red);
  for (const char* unknown : {"", "blu", "bluee", "green"})
    EXPECT_FALSE(enumValue<Colour>(unknown)) << unknown;
}

TEST(EnumTable, ChoicesLeaveAliasesOut) {
  const std::vector<Choice> choices = enumChoices<Colour>();
  ASSERT_EQ(choices.size(), 2u);
  EXPECT_EQ(choices[0].name, "red");
  EXPECT_EQ(choices[1].help, "as the sky");
}

TEST(ExitCodes, AreNumberedAsPromised) {
  const char* names[] = {"ok", "internal", "usage", "interrupted", "input", "output"};
  int number = 0;
  for (const char* name : names) {
    const std::optional<Code> code = enumValue<Code>(name);
    ASSERT_TRUE(code) << name;
    EXPECT_EQ(static_cast<int>(*code), number++);
  }
}

} // namespace
} // namespace qmesh
