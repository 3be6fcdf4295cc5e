// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace qmesh {

/// One name of an enum's value. A row without help is an alias: read, never written.
template <class E> struct EnumRow {
  E value;
  const char* name;
  const char* help = nullptr;
};

/// The name table of an enum, specialised beside the enum:
///   template <> struct EnumTable<Colour> {
///     static constexpr EnumRow<Colour> kRows[] = {{Colour::red, "red", "as blood"}, ...};
///   };
template <class E> struct EnumTable;

/// A name with one sentence about it.
struct Choice {
  std::string name;
  std::string help;
};

/// The first name of `value`. REQUIRES: the table has it.
template <class E> const char* enumName(E value) {
  for (const EnumRow<E>& row : EnumTable<E>::kRows)
    if (row.value == value)
      return row.name;
  assert(false);
  return "";
}

/// The value of a name or alias, upper and lower case alike; nothing for an unknown name.
template <class E> std::optional<E> enumValue(std::string_view name) {
  for (const EnumRow<E>& row : EnumTable<E>::kRows)
    if (equalIgnoringCase(name, row.name))
      return row.value;
  return std::nullopt;
}

/// Every value once, under its first name, in the order of the table.
template <class E> std::vector<Choice> enumChoices() {
  std::vector<Choice> choices;
  for (const EnumRow<E>& row : EnumTable<E>::kRows)
    if (row.help)
      choices.push_back({row.name, row.help});
  return choices;
}

} // namespace qmesh
