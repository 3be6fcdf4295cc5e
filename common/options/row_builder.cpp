// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/row_builder.h"

#include "options/row_builder_bodies.h"

namespace qmesh {

Status expected(const std::string& what) {
  return Status(Code::usage, "expected " + what);
}

std::string namesOf(const std::vector<Choice>& choices) {
  std::string names;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0)
      names += i + 1 == choices.size() ? " or " : ", ";
    names += choices[i].name;
  }
  return names;
}

Result<std::int64_t> parseIntegerIn(const std::string& text, std::int64_t minimum,
                                    std::int64_t maximum) {
  const std::optional<std::int64_t> value = parseInteger(text);
  if (value && *value >= minimum && *value <= maximum)
    return *value;
  const std::string least = std::to_string(minimum);
  return expected(maximum == std::numeric_limits<int>::max()
                      ? "a whole number, " + least + " or more"
                      : "a whole number from " + least + " to " + std::to_string(maximum));
}

Result<double> parseNumberIn(const std::string& text, double minimum, double maximum) {
  const std::optional<double> value = parseNumber(text);
  if (value && *value >= minimum && *value <= maximum)
    return *value;
  return expected("a number from " + formatNumber(minimum) + " to " + formatNumber(maximum));
}

template class BasicRowBuilder<BuildOptions>;

} // namespace qmesh
