// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// qmeshinfo: describes, validates and measures quantized-mesh terrain. Exit codes:
// docs/qmeshinfo.md.
#include <cstdio>

#include "console/console.h"
#include "console/interrupt.h"
#include "info_report.h"
#include "options/help.h"
#include "options/options_json.h"
#include "run.h"

namespace {

using namespace qmesh;

/// --validate found an error.
constexpr int kFound = 1;

bool print(const std::string& text) {
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() &&
         std::fflush(stdout) == 0;
}

int fail(Console& console, const OptionTable& table, const Status& status) {
  if (status.code() == Code::usage)
    console.usageError(usageLine(table), status.message());
  else
    console.error(status.message());
  return int(status.code());
}

int runCommand(const std::vector<std::string>& words) {
  Console console("qmeshinfo", stderr);
  const OptionTable table = infoTable();
  const auto line = parseInfoCommandLine(table, words);
  if (!line.ok())
    return fail(console, table, line.status());
  switch (line->request) {
  case Request::briefHelp:
    return print(briefHelpText(table, console.columns())) ? 0 : int(Code::output);
  case Request::help:
    return print(helpText(table, console.columns())) ? 0 : int(Code::output);
  case Request::version:
    return print("qmeshinfo " QMESH_VERSION "\n") ? 0 : int(Code::output);
  case Request::optionsJson:
    return print(optionsJson(table, QMESH_VERSION)) ? 0 : int(Code::output);
  case Request::listFindings:
    return print(line->options.json ? findingsJson() : findingsText()) ? 0 : int(Code::output);
  case Request::run:
    break;
  }
  console.setQuiet(line->options.run.quiet);
  for (const std::string& warning : line->warnings)
    console.warning(warning);
  installSignalHandlers();
  const Result<InfoResult> result = runInfo(line->options, console);
  if (!result.ok())
    return fail(console, table, result.status());
  if (!print(result->text))
    return fail(console, table, {Code::output, "standard output cannot be written"});
  return result->foundError ? kFound : 0;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return runCommand(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "qmeshinfo: error: %s\n", fault.what());
    return int(Code::internal);
  }
}
