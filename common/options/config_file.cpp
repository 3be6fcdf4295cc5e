// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/config_file.h"

#include <array>
#include <cstdio>
#include <memory>
#include <optional>

#include "base/text.h"

namespace qmesh {

namespace {

/// `text` up to a '#' that stands first or after a blank.
std::string_view withoutComment(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '#' && (i == 0 || text[i - 1] == ' ' || text[i - 1] == '\t'))
      return text.substr(0, i);
  return text;
}

/// The value after the '='; nothing where a quote is not closed or text follows it.
std::optional<std::string> valueOf(std::string_view text) {
  text = trimmed(text);
  if (text.empty() || text[0] != '"')
    return std::string(trimmed(withoutComment(text)));
  const std::size_t end = text.find('"', 1);
  if (end == std::string_view::npos || !trimmed(withoutComment(text.substr(end + 1))).empty())
    return std::nullopt;
  return std::string(text.substr(1, end - 1));
}

/// One line that is neither empty nor a comment; `place` is "FILE:LINE: ".
Result<Assignment> parseLine(const OptionTable& table, std::string_view line,
                             const std::string& place) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos)
    return Status(Code::usage, place + "expected 'name = value'");
  const std::string name(trimmed(line.substr(0, equals)));
  const OptionRow* row = table.byName(name);
  if (!row) {
    const Status unknown = unknownOption(table, "'" + name + "'", name);
    return Status(unknown.code(), place + unknown.message());
  }
  if (row->commandLineOnly)
    return Status(Code::usage, place + name + " is allowed on the command line only");
  const std::optional<std::string> value = valueOf(line.substr(equals + 1));
  if (!value)
    return Status(Code::usage, place + "expected one value in quotes");
  return Assignment{row, *value, place + name + " = " + *value};
}

} // namespace

Result<std::vector<Assignment>> parseConfig(const OptionTable& table, const std::string& text,
                                            const std::string& name) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::string_view rest = text;
  if (rest.substr(0, kByteOrderMark.size()) == kByteOrderMark)
    rest.remove_prefix(kByteOrderMark.size());
  std::vector<Assignment> assignments;
  int number = 0;
  for (const std::string_view line : split(rest, '\n')) {
    ++number;
    if (trimmed(withoutComment(trimmed(line))).empty())
      continue;
    const std::string place = name + ":" + std::to_string(number) + ": ";
    Result<Assignment> assignment = parseLine(table, line, place);
    if (!assignment.ok())
      return assignment.status();
    for (const Assignment& earlier : assignments)
      if (earlier.row == assignment->row && !earlier.row->repeatable)
        return Status(Code::usage, place + earlier.row->name + " is set twice; keep one line");
    assignments.push_back(*std::move(assignment));
  }
  return assignments;
}

Result<std::vector<Assignment>> readConfigFile(const OptionTable& table, const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
  std::string text;
  std::array<char, 4096> buffer;
  std::size_t got = 0;
  while (file && (got = std::fread(buffer.data(), 1, buffer.size(), file.get())) > 0)
    text.append(buffer.data(), got);
  if (!file || std::ferror(file.get()))
    return Status(Code::usage, "--config-file " + path + ": cannot be read; check the path");
  return parseConfig(table, text, path);
}

} // namespace qmesh
