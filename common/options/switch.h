// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/enum_table.h"

namespace qmesh {

/// A value of an option that is on or off.
enum class Switch { off, on };

template <> struct EnumTable<Switch> {
  static constexpr EnumRow<Switch> kRows[] = {
      {Switch::on, "on", "do it"}, {Switch::off, "off", "leave it out"},
      {Switch::on, "yes"},         {Switch::off, "no"},
      {Switch::on, "true"},        {Switch::off, "false"},
      {Switch::on, "1"},           {Switch::off, "0"},
  };
};

} // namespace qmesh
