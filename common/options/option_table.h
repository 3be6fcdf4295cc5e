// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "options/option_row.h"

namespace qmesh {

/// Every option of gdal2qmesh, once. Free-threaded where const.
class OptionTable {
 public:
  /// `methods`: names and sentences of the simplification methods this build has, for --method.
  explicit OptionTable(const std::vector<Choice>& methods);

  /// In the order of the help: group by group.
  const std::vector<OptionRow>& rows() const { return rows_; }

  /// The row of a long name or alias, without dashes; '_' reads as '-'. Null where there is none.
  const OptionRow* byName(std::string_view name) const;
  const OptionRow* byLetter(char letter) const;
  /// The row of the n-th argument without a name, from 1.
  const OptionRow* byPosition(int position) const;

  /// The long name a mistyped one is likely to mean; empty where nothing is close.
  std::string closestName(std::string_view name) const;

 private:
  std::vector<OptionRow> rows_;
};

} // namespace qmesh
