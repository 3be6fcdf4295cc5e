// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "options/option_row.h"
#include "options/program_text.h"

namespace qmesh {

/// Every option of a program, once. Free-threaded where const.
class OptionTable {
 public:
  static OptionTable of(ProgramText program, std::vector<OptionRow> rows);
  /// That of gdal2qmesh. `methods`: names and sentences of the simplification methods this build
  /// has, for --method.
  explicit OptionTable(const std::vector<Choice>& methods);

  const ProgramText& program() const { return program_; }
  /// In the order of the help: group by group.
  const std::vector<OptionRow>& rows() const { return rows_; }

  bool hasGroup(OptionGroup group) const;

  /// The row of a long name or alias, without dashes; '_' reads as '-'. Null where there is none.
  const OptionRow* byName(std::string_view name) const;
  const OptionRow* byLetter(char letter) const;
  /// The row of the n-th argument without a name, from 1.
  const OptionRow* byPosition(int position) const;

  /// The long name a mistyped one is likely to mean; empty where nothing is close.
  std::string closestName(std::string_view name) const;

 private:
  OptionTable() = default;

  ProgramText program_;
  std::vector<OptionRow> rows_;
};

} // namespace qmesh
