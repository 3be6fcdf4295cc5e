// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/help.h"

#include <algorithm>

#include "base/exit_codes.h"
#include "base/text.h"

namespace qmesh {

namespace {

constexpr int kIndent = 2;      ///< blanks before an option
constexpr int kTextColumn = 26; ///< where sentences begin
constexpr int kFewestColumns = 60;

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
  page.line("SPEC: a number that may differ per zoom");
  page.entry("V", "the same at all zooms: 5", kColumn);
  page.entry("V/2^z, V*2^z", "from the value at zoom 0: 5000/2^z halves at each zoom", kColumn);
  page.entry("V,V,V", "zoom 0, 1, 2; the last one repeats: 500,200,100", kColumn);
  page.entry("ZOOMS:V,ZOOMS:V", "by zoom or range, each V maybe a formula: 0:900,1-7:800/2^z,8-:2",
             kColumn);
}

void addExamples(Page& page) {
  page.line("");
  page.line("Examples");
  for (const Example& example : helpExamples()) {
    page.line(blanks(kIndent) + example.command);
    page.entry("", example.sentence, 3 * kIndent);
  }
}

void addExitCodes(Page& page) {
  constexpr int kColumn = 6;
  page.line("");
  page.line("Exit codes");
  for (const EnumRow<Code>& code : EnumTable<Code>::kRows)
    page.entry(std::to_string(static_cast<int>(code.value)), code.help, kColumn);
}

} // namespace

std::string usageLine() {
  return "usage: gdal2qmesh [options] INPUT [OUTPUT]";
}

std::vector<Example> helpExamples() {
  return {
      {"gdal2qmesh dem.tif", "All zooms the DEM has detail for, into the folder dem."},
      {"gdal2qmesh -z 0-12 -w cesium dem.tif terrain",
       "Zooms 0 to 12, with a page that shows them."},
      {"gdal2qmesh -s EPSG:32611 -a -9999 --void-fill interpolate dem.asc terrain",
       "A DEM that does not say its coordinate system, nor that -9999 marks voids."},
      {"gdal2qmesh --max-error 0-9:2000/2^z,10-:0.5 dem.tif terrain",
       "Errors in metres instead of pixels: half a metre from zoom 10 on."},
      {"gdal2qmesh --te -120 30 -110 40 --te-srs EPSG:4326 --memory 2GB big.vrt part",
       "A part of a large DEM, with 2 GB of memory."},
      {"gdal2qmesh --dry-run big.vrt", "How many tiles it would be, and how long it would take."},
  };
}

std::string helpText(const OptionTable& table, int columns) {
  Page page(columns);
  page.line(usageLine());
  page.line("");
  page.entry("", "Turns a digital elevation model into quantized-mesh terrain for CesiumJS.", 0);
  for (const EnumRow<OptionGroup>& group : EnumTable<OptionGroup>::kRows)
    addGroup(table, group, page);
  addSpec(page);
  addExamples(page);
  addExitCodes(page);
  return page.text();
}

} // namespace qmesh
