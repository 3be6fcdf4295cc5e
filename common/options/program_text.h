// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

namespace qmesh {

/// A command of the help's examples with what it does.
struct Example {
  std::string command;
  std::string sentence;
};

/// What an exit code means.
struct ExitCodeText {
  int code = 0;
  std::string sentence;
};

/// What the help says of a program beside its options.
struct ProgramText {
  std::string name;      ///< "gdal2qmesh"
  std::string arguments; ///< "[options] INPUT [OUTPUT]"
  std::string sentence;  ///< what it is for
  std::string inputHint; ///< said where there are too many arguments
  bool specs = false;    ///< whether options take a SPEC, which is then explained
  std::vector<Example> examples;
  std::vector<ExitCodeText> exitCodes;
};

/// That of gdal2qmesh.
ProgramText buildProgram();

} // namespace qmesh
