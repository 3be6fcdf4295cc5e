// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/enum_table.h"
#include "base/status.h"

namespace qmesh {

template <> struct EnumTable<Code> {
  static constexpr EnumRow<Code> kRows[] = {
      {Code::ok, "ok", "done"},
      {Code::internal, "internal", "a fault of the program"},
      {Code::usage, "usage", "an option is unknown, malformed or out of range"},
      {Code::interrupted, "interrupted", "stopped by Ctrl-C or a signal"},
      {Code::input, "input", "the input cannot be used"},
      {Code::output, "output", "the output cannot be written, is full or is already there"},
  };
};

} // namespace qmesh
