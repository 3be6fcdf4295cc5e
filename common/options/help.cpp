// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/help.h"

#include <algorithm>

#include "base/text.h"
#include "options/switch.h"

namespace qmesh {

namespace {

constexpr int kIndent = 2;      ///< blanks before an option
constexpr int kTextColumn = 26; ///< where sentences begin
constexpr int kFewestColumns = 60;
constexpr std::size_t kBriefExamples = 3;

std::string blanks(int count) {
  return std::string(static_cast<std::size_t>(count), ' ');
}

/// Text that grows line by line, broken between words.
class Page {
 public:
  explicit Page(int columns) : columns_(std::max(columns, kFewestColumns)) {}

  const std::string& text() const { return text_; }
  void line(const std::string& text) { text_ += text + "\n"; }

  /// `head` at kIndent and the words of `body` from `column` on; on lines of their own where the
  /// head is too long to stand before them.
  void entry(const std::string& head, const std::string& body, int column = kTextColumn) {
    std::string current = blanks(kIndent) + head;
    if (static_cast<int>(current.size()) + 2 > column && !head.empty()) {
      line(current);
      current.clear();
    }
    current.resize(static_cast<std::size_t>(column), ' ');
    bool empty = true;
    for (const std::string_view word : split(body, ' ')) {
      if (!empty && static_cast<int>(current.size() + 1 + word.size()) > columns_) {
        line(current);
        current = blanks(column);
        empty = true;
      }
      current += (empty ? "" : " ") + std::string(word);
      empty = false;
    }
    line(current);
  }

 private:
  int columns_;
  std::string text_;
};

/// "-j, --num-threads, --processes N".
std::string heading(const OptionRow& row) {
  if (row.position != 0)
    return row.placeholder;
  const bool on = row.type == OptionType::flag && row.defaultText() == enumName(Switch::on);
  std::string text = row.letter == 0 ? "" : std::string("-") + row.letter + ", ";
  text += (on ? "--[no-]" : "--") + row.name;
  for (const std::string& alias : row.aliases)
    text += ", --" + alias;
  return row.placeholder.empty() ? text : text + " " + row.placeholder;
}

/// "[0 to 24; default: 0]" and the like, or nothing.
std::string facts(const OptionRow& row) {
  std::vector<std::string> facts;
  std::vector<std::string> bareChoices;
  for (const Choice& choice : row.choices)
    if (choice.help.empty())
      bareChoices.push_back(choice.name);
  if (!bareChoices.empty())
    facts.push_back(join(bareChoices, ", "));
  if (!row.methods.empty())
    facts.push_back(row.methodsText());
  if (const std::string range = row.rangeText(); !range.empty())
    facts.push_back(range);
  const std::string value = row.defaultText();
  if (!value.empty() && value != enumName(Switch::off))
    facts.push_back("default: " + value);
  else if (value.empty() && !row.whenUnset.empty())
    facts.push_back("default: " + row.whenUnset);
  if (row.repeatable)
    facts.push_back("repeatable");
  if (row.advanced)
    facts.push_back("advanced");
  return facts.empty() ? "" : " [" + join(facts, "; ") + "]";
}

void addGroup(const OptionTable& table, const EnumRow<OptionGroup>& group, Page& page) {
  if (!table.hasGroup(group.value))
    return;
  page.line("");
  page.line(std::string(group.name) + ": " + group.help);
  for (const OptionRow& row : table.rows()) {
    if (row.group != group.value)
      continue;
    page.entry(heading(row), row.help + facts(row));
    if (row.type != OptionType::choice || row.choices.size() < 2)
      continue;
    for (const Choice& choice : row.choices)
      if (!choice.help.empty() && row.placeholder.find('|') == std::string::npos)
        page.entry("", choice.name + ": " + choice.help, kTextColumn + 2);
  }
}

void addSpec(Page& page) {
  constexpr int kColumn = 20;
  page.line("");
  page.line("SPEC: a number, or numbers per zoom");
  page.entry("V", "the same at all zooms, for example 5", kColumn);
  page.entry("V/2^z, V*2^z", "from the value at zoom 0: 5000/2^z is halved at each zoom", kColumn);
  page.entry("V,V,V", "for zooms 0, 1, 2; the last one is used for deeper zooms: 500,200,100",
             kColumn);
  page.entry("ZOOMS:V,ZOOMS:V",
             "by zoom or range of zooms, V may be a formula: 0:900,1-7:800/2^z,8-:2", kColumn);
}

void addExamples(const ProgramText& program, std::size_t most, Page& page) {
  page.line("");
  page.line("Examples");
  for (std::size_t k = 0; k < std::min(most, program.examples.size()); ++k) {
    const Example& example = program.examples[k];
    page.line(blanks(kIndent) + example.command);
    page.entry("", example.sentence, 3 * kIndent);
  }
}

void addExitCodes(const ProgramText& program, Page& page) {
  constexpr int kColumn = 6;
  page.line("");
  page.line("Exit codes");
  for (const ExitCodeText& exit : program.exitCodes)
    page.entry(std::to_string(exit.code), exit.sentence, kColumn);
}

} // namespace

std::string usageLine(const OptionTable& table) {
  return "usage: " + table.program().name + " " + table.program().arguments;
}

std::string briefHelpText(const OptionTable& table, int columns) {
  Page page(columns);
  page.line(usageLine(table));
  page.line("");
  page.entry("", table.program().sentence, 0);
  page.line("");
  for (const OptionRow& row : table.rows())
    if (row.essential)
      page.entry(heading(row), row.help + facts(row));
  addExamples(table.program(), kBriefExamples, page);
  page.line("");
  page.line("All options: " + table.program().name + " --help");
  return page.text();
}

std::string helpText(const OptionTable& table, int columns) {
  Page page(columns);
  page.line(usageLine(table));
  page.line("");
  page.entry("", table.program().sentence, 0);
  for (const EnumRow<OptionGroup>& group : EnumTable<OptionGroup>::kRows)
    addGroup(table, group, page);
  if (table.program().specs)
    addSpec(page);
  addExamples(table.program(), table.program().examples.size(), page);
  addExitCodes(table.program(), page);
  return page.text();
}

} // namespace qmesh
