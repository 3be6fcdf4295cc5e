// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/row_builder.h"

#include "options/switch.h"

namespace qmesh {

Status expected(const std::string& what) {
  return Status(Code::usage, "expected " + what);
}

std::string namesOf(const std::vector<Choice>& choices) {
  std::string names;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0)
      names += i + 1 == choices.size() ? " or " : ", ";
    names += choices[i].name;
  }
  return names;
}

Result<std::int64_t> parseIntegerIn(const std::string& text, std::int64_t minimum,
                                    std::int64_t maximum) {
  const std::optional<std::int64_t> value = parseInteger(text);
  if (value && *value >= minimum && *value <= maximum)
    return *value;
  const std::string least = std::to_string(minimum);
  return expected(maximum == std::numeric_limits<int>::max()
                      ? "a whole number, " + least + " or more"
                      : "a whole number from " + least + " to " + std::to_string(maximum));
}

Result<double> parseNumberIn(const std::string& text, double minimum, double maximum) {
  const std::optional<double> value = parseNumber(text);
  if (value && *value >= minimum && *value <= maximum)
    return *value;
  return expected("a number from " + formatNumber(minimum) + " to " + formatNumber(maximum));
}

Status setSwitch(bool& field, const std::string& text) {
  const std::optional<Switch> value = enumValue<Switch>(text);
  if (!value)
    return expected(namesOf(switchChoices()));
  field = *value == Switch::on;
  return {};
}

std::string switchText(bool on) {
  return enumName(on ? Switch::on : Switch::off);
}

std::vector<Choice> switchChoices() {
  return enumChoices<Switch>();
}

Status setText(std::string& field, const std::string& text, bool mayBeEmpty) {
  if (text.empty() && !mayBeEmpty)
    return expected("a value that is not empty");
  field = text;
  return {};
}

Status setSpec(LevelSpec& field, const std::string& text) {
  Result<LevelSpec> spec = LevelSpec::parse(text);
  if (!spec.ok())
    return spec.status();
  field = *std::move(spec);
  return {};
}

Status setChoice(std::string& field, const std::string& text, const std::vector<Choice>& choices) {
  for (const Choice& choice : choices) {
    if (!equalIgnoringCase(choice.name, text))
      continue;
    field = choice.name;
    return {};
  }
  return expected(namesOf(choices));
}

Status addToList(std::vector<std::string>& field, const std::string& text, OptionType type) {
  const std::size_t equals = text.find('=');
  if (type == OptionType::keyValue && (equals == std::string::npos || equals == 0))
    return expected("KEY=VALUE");
  std::string value;
  QMESH_RETURN_IF_ERROR(setText(value, text, type == OptionType::keyValue));
  field.push_back(std::move(value));
  return {};
}

RowBuilder::RowBuilder(OptionGroup group, std::string name, char letter) {
  row_.group = group;
  row_.name = std::move(name);
  row_.letter = letter;
}

RowBuilder& RowBuilder::alias(std::string name) {
  row_.aliases.push_back(std::move(name));
  return *this;
}

RowBuilder& RowBuilder::value(std::string placeholder) {
  row_.placeholder = std::move(placeholder);
  return *this;
}

RowBuilder& RowBuilder::unit(std::string unit) {
  row_.unit = std::move(unit);
  return *this;
}

RowBuilder& RowBuilder::help(std::string sentence) {
  row_.help = std::move(sentence);
  return *this;
}

RowBuilder& RowBuilder::whenUnset(std::string text) {
  row_.whenUnset = std::move(text);
  return *this;
}

RowBuilder& RowBuilder::refusal(std::string text) {
  row_.refusal = std::move(text);
  return *this;
}

RowBuilder& RowBuilder::position(int n) {
  row_.position = n;
  return *this;
}

RowBuilder& RowBuilder::essential() {
  row_.essential = true;
  return *this;
}

RowBuilder& RowBuilder::advanced() {
  row_.advanced = true;
  return *this;
}

RowBuilder& RowBuilder::words(int n) {
  row_.values = n;
  return *this;
}

RowBuilder& RowBuilder::powersOfTwo(int first, int last) {
  row_.minimum = first;
  row_.maximum = last;
  for (int n = first; n <= last; n *= 2)
    row_.choices.push_back({std::to_string(n), ""});
  return *this;
}

RowBuilder& RowBuilder::methods(std::vector<std::string> names) {
  row_.methods = std::move(names);
  return *this;
}

RowBuilder& RowBuilder::commandLineOnly() {
  row_.commandLineOnly = true;
  return *this;
}

RowBuilder& RowBuilder::notInDriver(std::string instead) {
  row_.notInDriver = true;
  row_.translateOption = std::move(instead);
  return *this;
}

RowBuilder& RowBuilder::noEffect(std::string why, int values) {
  row_.ignored = std::move(why);
  row_.values = values;
  row_.notInDriver = true;
  row_.type = values == 0 ? OptionType::flag : OptionType::text;
  row_.set = [](const OptionStructs&, const std::string&) { return Status(); };
  row_.get = [](const ConstOptionStructs&) { return std::string(); };
  return *this;
}

RowBuilder& RowBuilder::request(Request request) {
  noEffect("");
  row_.request = request;
  row_.commandLineOnly = true;
  return *this;
}

} // namespace qmesh
