// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/creation_options.h"

#include "base/enum_table.h"
#include "base/text.h"
#include "options/switch.h"

namespace qmesh {

namespace {

std::string attribute(const char* name, const std::string& value) {
  return value.empty() ? "" : std::string(" ") + name + "='" + escapeMarkup(value) + "'";
}

bool isSwitch(const OptionRow& row) {
  return row.type == OptionType::flag ||
         (row.choices.size() == 2 && row.choices[0].name == enumName(Switch::on) &&
          row.choices[1].name == enumName(Switch::off));
}

/// GDAL's name of a type.
std::string typeName(const OptionRow& row) {
  if (isSwitch(row))
    return "boolean";
  if (!row.choices.empty())
    return "string-select";
  if (row.type == OptionType::integer)
    return "int";
  return row.type == OptionType::number ? "float" : "string";
}

std::string defaultOf(const OptionRow& row) {
  const std::string text = row.defaultText();
  if (isSwitch(row))
    return text == enumName(Switch::on) ? "YES" : "NO";
  return text;
}

std::string description(const OptionTable& table, const OptionRow& row) {
  std::string text = row.help;
  if (!row.methods.empty())
    text += " Only for " + row.methodsText() + ".";
  if (!row.unit.empty())
    text += " Unit: " + row.unit + ".";
  if (row.defaultText().empty() && !row.whenUnset.empty())
    text += " Default: " + row.whenUnset + ".";
  return inCreationWords(table, text);
}

std::string optionXml(const OptionTable& table, const OptionRow& row) {
  const std::string type = typeName(row);
  std::string xml = "  <Option" + attribute("name", row.creationOption()) + attribute("type", type);
  if (!row.aliases.empty()) {
    OptionRow other;
    other.name = row.aliases[0];
    xml += attribute("alias", other.creationOption());
  }
  if (type == "int" || type == "float") {
    if (row.minimum)
      xml += attribute("min", formatNumber(*row.minimum));
    if (row.maximum)
      xml += attribute("max", formatNumber(*row.maximum));
  }
  xml += attribute("default", defaultOf(row)) + attribute("description", description(table, row));
  if (type != "string-select")
    return xml + "/>\n";
  xml += ">\n";
  for (const Choice& choice : row.choices)
    xml += "    <Value>" + escapeMarkup(choice.name) + "</Value>\n";
  return xml + "  </Option>\n";
}

/// What GDAL itself takes from the list of creation options.
bool isGdalsOwn(const std::string& name) {
  return name.empty() || name[0] == '@' || equalIgnoringCase(name, "QUIET_DELETE_ON_CREATE_COPY") ||
         equalIgnoringCase(name, "APPEND_SUBDATASET");
}

std::string lowerCase(std::string text) {
  for (char& c : text)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

Status unknown(const OptionTable& table, const std::string& name) {
  const OptionRow* known = table.byName(lowerCase(name));
  if (known && !known->translateOption.empty())
    return {Code::usage, name + " is not a creation option; use " + known->translateOption +
                             " of gdal_translate"};
  if (known)
    return {Code::usage, name + " is an option of gdal2qmesh, not of the driver"};
  const OptionRow* closest = table.byName(table.closestName(lowerCase(name)));
  return {Code::usage, "unknown creation option " + name +
                           (closest && closest->isCreationOption()
                                ? "; did you mean " + closest->creationOption() + "?"
                                : "; gdalinfo --format QMESH lists all")};
}

bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_';
}

/// "--max-error", "-s" or "--no-normals" as the driver has it; itself where it has nothing like it.
std::string translated(const OptionTable& table, const std::string& word) {
  const bool isLong = word.compare(0, 2, "--") == 0;
  const bool isNegated = word.compare(0, 5, "--no-") == 0;
  const OptionRow* row = nullptr;
  if (isLong)
    row = table.byName(word.substr(isNegated ? 5 : 2));
  else if (word.size() == 2)
    row = table.byLetter(word[1]);
  if (!row)
    return word;
  if (row->isCreationOption())
    return row->creationOption() + (isNegated ? "=NO" : "");
  return row->translateOption.empty() ? word : row->translateOption;
}

} // namespace

std::string inCreationWords(const OptionTable& table, const std::string& sentence) {
  std::string out;
  for (std::size_t at = 0; at < sentence.size();) {
    const bool afterBreak =
        at == 0 || std::string(" ('").find(sentence[at - 1]) != std::string::npos;
    const bool afterOption =
        at > 0 && sentence[at - 1] == '/' && sentence.compare(at, 2, "--") == 0;
    const bool begins = sentence[at] == '-' && (afterBreak || afterOption);
    std::size_t end = at + 1;
    while (begins && end < sentence.size() && isWordCharacter(sentence[end]))
      ++end;
    const std::string piece = sentence.substr(at, end - at);
    out += begins ? translated(table, piece) : piece;
    at = end;
  }
  return out;
}

std::string creationOptionXml(const OptionTable& table) {
  std::string xml = "<CreationOptionList>\n";
  for (const OptionRow& row : table.rows())
    if (row.isCreationOption())
      xml += optionXml(table, row);
  return xml + "</CreationOptionList>\n";
}

Result<std::vector<Assignment>> parseCreationOptions(const OptionTable& table,
                                                     const std::vector<std::string>& pairs) {
  std::vector<Assignment> assignments;
  for (const std::string& pair : pairs) {
    const std::size_t equals = pair.find('=');
    const std::string name = pair.substr(0, equals);
    if (isGdalsOwn(name))
      continue;
    if (equals == std::string::npos)
      return Status(Code::usage, "creation option '" + pair + "': expected NAME=VALUE");
    const OptionRow* row = table.byName(lowerCase(name));
    if (!row || !row->isCreationOption())
      return unknown(table, name);
    const Assignment assignment{row, pair.substr(equals + 1), pair};
    for (const Assignment& earlier : assignments)
      if (earlier.row == row && !row->repeatable && earlier.value != assignment.value)
        return Status(Code::usage, earlier.place + " and " + pair + " contradict; keep one");
    assignments.push_back(assignment);
  }
  return assignments;
}

} // namespace qmesh
