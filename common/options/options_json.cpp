// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/options_json.h"

#include "base/text.h"

namespace qmesh {

namespace {

using Members = std::vector<std::string>;

void add(Members& members, const char* key, const std::string& json) {
  members.push_back(jsonString(key) + ": " + json);
}

void addText(Members& members, const char* key, const std::string& text) {
  if (!text.empty())
    add(members, key, jsonString(text));
}

void addNumber(Members& members, const char* key, const std::optional<double>& number) {
  if (number)
    add(members, key, formatNumber(*number));
}

void addTrue(Members& members, const char* key, bool value) {
  if (value)
    add(members, key, "true");
}

std::string object(const Members& members) {
  return "{" + join(members, ", ") + "}";
}

std::string array(const Members& items, const char* separator = ", ") {
  return "[" + join(items, separator) + "]";
}

std::string named(const std::string& name, const std::string& help) {
  Members members;
  addText(members, "name", name);
  addText(members, "help", help);
  return object(members);
}

std::string rowJson(const OptionRow& row) {
  Members aliases;
  for (const std::string& alias : row.aliases)
    aliases.push_back(jsonString(alias));
  Members choices;
  for (const Choice& choice : row.choices)
    choices.push_back(named(choice.name, choice.help));

  Members members;
  addText(members, "name", row.name);
  if (row.isCreationOption())
    addText(members, "creationOption", row.creationOption());
  addText(members, "letter", row.letter == 0 ? "" : std::string(1, row.letter));
  if (!aliases.empty())
    add(members, "aliases", array(aliases));
  addText(members, "group", enumName(row.group));
  addText(members, "type", enumName(row.type));
  addText(members, "placeholder", row.placeholder);
  addText(members, "unit", row.unit);
  addNumber(members, "minimum", row.minimum);
  addNumber(members, "maximum", row.maximum);
  if (!choices.empty())
    add(members, "choices", array(choices));
  addText(members, "default", row.defaultText());
  addText(members, "whenUnset", row.whenUnset);
  addText(members, "help", row.help);
  add(members, "values", std::to_string(row.values));
  if (row.position != 0)
    add(members, "position", std::to_string(row.position));
  Members methods;
  for (const std::string& method : row.methods)
    methods.push_back(jsonString(method));
  if (!methods.empty())
    add(members, "methods", array(methods));
  addTrue(members, "essential", row.essential);
  addTrue(members, "advanced", row.advanced);
  addTrue(members, "repeatable", row.repeatable);
  addTrue(members, "commandLineOnly", row.commandLineOnly);
  addText(members, "ignored", row.ignored);
  return object(members);
}

} // namespace

std::string optionsJson(const OptionTable& table, const std::string& version) {
  const char* nextLine = ",\n  ";
  Members groups;
  for (const EnumRow<OptionGroup>& group : EnumTable<OptionGroup>::kRows)
    if (table.hasGroup(group.value))
      groups.push_back(named(group.name, group.help));
  Members rows;
  for (const OptionRow& row : table.rows())
    rows.push_back(rowJson(row));
  Members members;
  addText(members, "program", table.program().name);
  addText(members, "version", version);
  add(members, "groups", "\n " + array(groups, nextLine));
  add(members, "options", "\n " + array(rows, nextLine));
  return object(members) + "\n";
}

} // namespace qmesh
