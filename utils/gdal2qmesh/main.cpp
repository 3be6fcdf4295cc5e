// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// gdal2qmesh: a DEM to Cesium quantized-mesh terrain. Exit codes: base/status.h.
#include <cstdio>

#include "console/console.h"
#include "console/interrupt.h"
#include "options/help.h"
#include "options/options_json.h"
#include "options/parse.h"
#include "run.h"
#include "simplify/simplifier.h"

namespace {

using namespace qmesh;

int runCommand(const std::vector<std::string>& words) {
  Console console("gdal2qmesh");
  const OptionTable table(simplifierChoices());
  const auto line = parseCommandLine(table, words);
  if (!line.ok()) {
    console.usageError(usageLine(table), line.status().message());
    return int(line.status().code());
  }
  switch (line->request) {
  case Request::briefHelp:
    std::fputs(briefHelpText(table, console.columns()).c_str(), stdout);
    return 0;
  case Request::help:
    std::fputs(helpText(table, console.columns()).c_str(), stdout);
    return 0;
  case Request::version:
    std::puts("gdal2qmesh " QMESH_VERSION);
    return 0;
  case Request::optionsJson:
    std::fputs(optionsJson(table, QMESH_VERSION).c_str(), stdout);
    return 0;
  case Request::listFindings:
  case Request::run:
    break;
  }
  console.setQuiet(line->options.run.quiet);
  console.setVerbose(line->options.run.verbose);
  for (const std::string& warning : line->warnings)
    console.warning(warning);
  installSignalHandlers();
  const Status status = runBuild(line->options, console);
  if (status.code() == Code::usage) {
    console.usageError(usageLine(table), status.message());
  } else if (!status.ok()) {
    console.error(status.message());
  }
  return int(status.code());
}

} // namespace

int main(int argc, char** argv) {
  try {
    return runCommand(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "gdal2qmesh: error: %s\n", fault.what());
    return int(Code::internal);
  }
}
