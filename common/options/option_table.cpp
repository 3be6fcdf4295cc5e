// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/option_table.h"

#include <algorithm>
#include <numeric>

#include "base/text.h"
#include "options/option_rows.h"

namespace qmesh {

namespace {

std::string dashed(std::string_view name) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '_', '-');
  return text;
}

/// Edits (insert, remove, replace one character) between two words: Levenshtein's distance.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::vector<std::string> namesOf(const OptionRow& row) {
  std::vector<std::string> names = row.aliases;
  names.insert(names.begin(), row.name);
  return names;
}

} // namespace

std::string OptionRow::creationOption() const {
  std::string text = name;
  for (char& c : text)
    c = c == '-' ? '_' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return text;
}

std::string OptionRow::methodsText() const {
  return methods.empty() ? "" : (methods.size() > 1 ? "methods " : "method ") + join(methods, ", ");
}

std::string OptionRow::rangeText() const {
  return choices.empty() ? qmesh::rangeText(minimum, maximum, unit) : unit;
}

OptionTable OptionTable::of(ProgramText program, std::vector<OptionRow> rows) {
  OptionTable table;
  table.program_ = std::move(program);
  table.rows_ = std::move(rows);
  return table;
}

OptionTable::OptionTable(const std::vector<Choice>& methods)
    : program_(buildProgram()), rows_(optionRows(methods)) {}

bool OptionTable::hasGroup(OptionGroup group) const {
  return std::any_of(rows_.begin(), rows_.end(),
                     [&](const OptionRow& row) { return row.group == group; });
}

const OptionRow* OptionTable::byName(std::string_view name) const {
  for (const OptionRow& row : rows_)
    for (const std::string& known : namesOf(row))
      if (dashed(known) == dashed(name))
        return &row;
  return nullptr;
}

const OptionRow* OptionTable::byLetter(char letter) const {
  for (const OptionRow& row : rows_)
    if (row.letter != 0 && row.letter == letter)
      return &row;
  return nullptr;
}

const OptionRow* OptionTable::byPosition(int position) const {
  for (const OptionRow& row : rows_)
    if (row.position != 0 && row.position == position)
      return &row;
  return nullptr;
}

std::string OptionTable::closestName(std::string_view name) const {
  std::string closest;
  std::size_t fewest = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const OptionRow& row : rows_) {
    if (row.position != 0)
      continue;
    for (const std::string& known : namesOf(row)) {
      const bool begins = name.size() > 2 && known.compare(0, name.size(), name) == 0;
      const std::size_t edits = begins ? 0 : editDistance(dashed(name), dashed(known));
      if (edits >= fewest)
        continue;
      fewest = edits;
      closest = known;
    }
  }
  return closest;
}

} // namespace qmesh
