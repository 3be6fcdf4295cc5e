// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/parse.h"

#include <algorithm>

#include "base/text.h"
#include "options/assignment.h"
#include "options/config_file.h"
#include "options/switch.h"
#include "options/validate.h"

namespace qmesh {

namespace {

bool startsWith(std::string_view text, std::string_view head) {
  return text.substr(0, head.size()) == head;
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether `text` begins as a number does: a digit after "-" or "." at most.
bool startsNumber(std::string_view text) {
  const std::size_t first = text.find_first_not_of("-.");
  return first != std::string_view::npos && first <= 2 && isDigit(text[first]);
}

/// Turns words into assignments, in order, up to an option that asks for something else than a
/// run.
class WordReader {
 public:
  WordReader(const OptionTable& table, const std::vector<std::string>& words)
      : table_(table), words_(words) {}

  Status read();

  Request request = Request::run;
  std::vector<Assignment> assignments;

 private:
  Status readPositional(const std::string& word);
  Status readLong(const std::string& word);
  Status readShort(const std::string& word);
  Status readValues(const OptionRow& row, const std::string& written);
  void assign(const OptionRow& row, const std::string& value, const std::string& place);
  bool isOption(const std::string& word) const;
  const OptionRow* negated(std::string_view name) const;

  const OptionTable& table_;
  const std::vector<std::string>& words_;
  std::size_t next_ = 0;
  int positionals_ = 0;
};

Status WordReader::read() {
  bool optionsEnded = false;
  while (next_ < words_.size() && request == Request::run) {
    const std::string& word = words_[next_++];
    if (!optionsEnded && word == "--")
      optionsEnded = true;
    else if (optionsEnded || word.size() < 2 || word[0] != '-')
      QMESH_RETURN_IF_ERROR(readPositional(word));
    else
      QMESH_RETURN_IF_ERROR(startsWith(word, "--") ? readLong(word) : readShort(word));
  }
  return {};
}

Status WordReader::readPositional(const std::string& word) {
  const OptionRow* row = table_.byPosition(++positionals_);
  if (!row)
    return Status(Code::usage, "unexpected argument '" + word + "' (quote paths with spaces; " +
                                   table_.program().inputHint + ")");
  assign(*row, word, row->placeholder);
  return {};
}

/// The row of "no-NAME" where NAME is a flag with an effect.
const OptionRow* WordReader::negated(std::string_view name) const {
  if (!startsWith(name, "no-"))
    return nullptr;
  const OptionRow* row = table_.byName(name.substr(3));
  return row && row->type == OptionType::flag && !row->defaultText().empty() ? row : nullptr;
}

Status WordReader::readLong(const std::string& word) {
  const std::size_t equals = word.find('=');
  const std::string written = word.substr(0, equals);
  const std::string name = written.substr(2);
  const OptionRow* row = table_.byName(name);
  if (row && row->position != 0)
    row = nullptr;
  if (row && equals == std::string::npos)
    return readValues(*row, written);
  if (row) {
    assign(*row, word.substr(equals + 1), word);
    return {};
  }
  row = negated(name);
  if (!row)
    return unknownOption(table_, written, name);
  if (equals != std::string::npos)
    return Status(Code::usage, written + " takes no value");
  assign(*row, enumName(Switch::off), written);
  return {};
}

Status WordReader::readShort(const std::string& word) {
  const OptionRow* row = table_.byLetter(word[1]);
  if (row && word.size() == 2)
    return readValues(*row, word);
  const std::string rest = word.substr(2);
  if (!row || row->values != 1 || !startsNumber(rest))
    return unknownOption(table_, word, word.substr(1));
  assign(*row, rest, word);
  return {};
}

/// Takes the words an option's value is made of.
Status WordReader::readValues(const OptionRow& row, const std::string& written) {
  if (row.values == 0) {
    assign(row, enumName(Switch::on), written);
    return {};
  }
  std::vector<std::string> values;
  for (int i = 0; i < row.values; ++i) {
    if (next_ == words_.size() || isOption(words_[next_]))
      return Status(Code::usage,
                    written + " needs " +
                        (row.values == 1 ? "a value" : std::to_string(row.values) + " values") +
                        ": " + row.placeholder);
    values.push_back(words_[next_++]);
  }
  const std::string value = join(values, " ");
  assign(row, value, written + " " + value);
  return {};
}

/// Whether a word in the place of a value is an option: then the value was forgotten.
bool WordReader::isOption(const std::string& word) const {
  if (word == "--")
    return true;
  if (word.size() == 2 && word[0] == '-')
    return table_.byLetter(word[1]) != nullptr;
  if (!startsWith(word, "--"))
    return false;
  const std::string name = word.substr(2, word.find('=') - 2);
  return table_.byName(name) != nullptr || negated(name) != nullptr;
}

void WordReader::assign(const OptionRow& row, const std::string& value, const std::string& place) {
  request = row.request;
  assignments.push_back({&row, value, place});
}

/// Without the rows the command line sets itself, so that its lists replace the file's.
std::vector<Assignment> notOverridden(const std::vector<Assignment>& file,
                                      const std::vector<Assignment>& commandLine) {
  std::vector<Assignment> kept;
  for (const Assignment& assignment : file)
    if (std::none_of(commandLine.begin(), commandLine.end(),
                     [&](const Assignment& other) { return other.row == assignment.row; }))
      kept.push_back(assignment);
  return kept;
}

/// The file the command line names; empty for none.
std::string configFileOf(const OptionTable& table, const std::vector<Assignment>& commandLine) {
  const OptionRow* row = table.byName("config-file");
  std::string path;
  for (const Assignment& assignment : commandLine)
    if (assignment.row == row)
      path = assignment.value;
  return path;
}

void warnOfIgnored(const std::vector<Assignment>& assignments, std::vector<std::string>& warnings) {
  for (const Assignment& assignment : assignments)
    if (!assignment.row->ignored.empty())
      warnings.push_back(assignment.place + " has no effect: " + assignment.row->ignored);
}

} // namespace

std::string defaultOutput(const std::string& input) {
  std::string name = input;
  while (!name.empty() && name.back() == '/')
    name.pop_back();
  name.erase(0, name.rfind('/') + 1);
  const std::size_t dot = name.rfind('.');
  if (dot != std::string::npos && dot > 0)
    name.erase(dot);
  return name == input || name == "." || name == ".." ? std::string() : name;
}

Result<ParsedWords> parseWords(const OptionTable& table, const std::vector<std::string>& words) {
  WordReader reader(table, words);
  QMESH_RETURN_IF_ERROR(reader.read());
  ParsedWords parsed;
  parsed.request = reader.request;
  parsed.assignments = reader.assignments;
  if (parsed.request != Request::run)
    return parsed;
  const std::string path = configFileOf(table, reader.assignments);
  if (!path.empty()) {
    const auto file = readConfigFile(table, path);
    if (!file.ok())
      return file.status();
    const std::vector<Assignment> kept = notOverridden(*file, reader.assignments);
    parsed.assignments.insert(parsed.assignments.begin(), kept.begin(), kept.end());
  }
  warnOfIgnored(parsed.assignments, parsed.warnings);
  return parsed;
}

Result<CommandLine> parseCommandLine(const OptionTable& table,
                                     const std::vector<std::string>& words) {
  Result<ParsedWords> parsed = parseWords(table, words);
  if (!parsed.ok())
    return parsed.status();
  CommandLine line;
  line.request = parsed->request;
  if (line.request != Request::run)
    return line;
  line.warnings = parsed->warnings;
  BuildOptions& options = line.options;
  QMESH_RETURN_IF_ERROR(applyAssignments(parsed->assignments, options));
  if (options.input.path.empty())
    return Status(Code::usage, "INPUT is missing: the DEM to read");
  if (options.output.path.empty())
    options.output.path = defaultOutput(options.input.path);
  if (options.output.path.empty())
    return Status(Code::usage,
                  "OUTPUT is missing: no default follows from '" + options.input.path + "'");
  QMESH_RETURN_IF_ERROR(validate(options, line.warnings));
  return line;
}

} // namespace qmesh
