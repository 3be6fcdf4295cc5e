// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include "base/text.h"
#include "options/choices.h"
#include "options/level_spec.h"
#include "options/row_builder.h"

// The bodies of BasicRowBuilder: for the file that defines the rows of a program, which
// instantiates it for that program's options.

namespace qmesh {

inline Status setSwitch(bool& field, const std::string& text) {
  const std::optional<Switch> value = enumValue<Switch>(text);
  if (!value)
    return expected(namesOf(enumChoices<Switch>()));
  field = *value == Switch::on;
  return {};
}

inline std::string switchText(bool on) {
  return enumName(on ? Switch::on : Switch::off);
}

inline Status checkKeyValue(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    return expected("KEY=VALUE");
  return {};
}

inline Status checkNotEmpty(const std::string& text) {
  return text.empty() ? expected("a value that is not empty") : Status();
}

template <class Options>
BasicRowBuilder<Options>::BasicRowBuilder(OptionGroup group, std::string name, char letter) {
  row_.group = group;
  row_.name = std::move(name);
  row_.letter = letter;
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::alias(std::string name) {
  row_.aliases.push_back(std::move(name));
  return *this;
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::value(std::string placeholder) {
  row_.placeholder = std::move(placeholder);
  return *this;
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::unit(std::string unit) {
  row_.unit = std::move(unit);
  return *this;
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::help(std::string sentence) {
  row_.help = std::move(sentence);
  return *this;
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::whenUnset(std::string text) {
  row_.whenUnset = std::move(text);
  return *this;
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::refusal(std::string text) {
  row_.refusal = std::move(text);
  return *this;
}

template <class Options> BasicRowBuilder<Options>& BasicRowBuilder<Options>::position(int n) {
  row_.position = n;
  return *this;
}

template <class Options> BasicRowBuilder<Options>& BasicRowBuilder<Options>::advanced() {
  row_.advanced = true;
  return *this;
}

template <class Options> BasicRowBuilder<Options>& BasicRowBuilder<Options>::words(int n) {
  row_.values = n;
  return *this;
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::powersOfTwo(int first, int last) {
  row_.minimum = first;
  row_.maximum = last;
  for (int n = first; n <= last; n *= 2)
    row_.choices.push_back({std::to_string(n), ""});
  return *this;
}

template <class Options> BasicRowBuilder<Options>& BasicRowBuilder<Options>::commandLineOnly() {
  row_.commandLineOnly = true;
  return *this;
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::notInDriver(std::string instead) {
  row_.notInDriver = true;
  row_.translateOption = std::move(instead);
  return *this;
}

template <class Options>
BasicRowBuilder<Options>&
BasicRowBuilder<Options>::custom(OptionType type,
                                 std::function<Status(Options&, const std::string&)> set,
                                 std::function<std::string(const Options&)> get) {
  row_.type = type;
  row_.initial = get(Options());
  row_.set = [set = std::move(set)](OptionValues& options, const std::string& text) {
    return set(static_cast<Options&>(options), text);
  };
  row_.get = [get = std::move(get)](const OptionValues& options) {
    return get(static_cast<const Options&>(options));
  };
  return *this;
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::flag(bool Options::*field) {
  row_.values = 0;
  return custom(
      OptionType::flag,
      [=](Options& options, const std::string& text) { return setSwitch(options.*field, text); },
      [=](const Options& options) { return switchText(options.*field); });
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::onOff(bool Options::*field) {
  flag(field);
  row_.values = 1;
  row_.type = OptionType::choice;
  row_.choices = enumChoices<Switch>();
  return *this;
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::text(std::string Options::*field,
                                                         OptionType type, bool mayBeEmpty) {
  return custom(
      type,
      [=](Options& options, const std::string& text) -> Status {
        if (!mayBeEmpty)
          QMESH_RETURN_IF_ERROR(checkNotEmpty(text));
        options.*field = text;
        return {};
      },
      [=](const Options& options) { return options.*field; });
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::spec(std::string Options::*field) {
  return custom(
      OptionType::spec,
      [=](Options& options, const std::string& text) -> Status {
        const Result<LevelSpec> spec = LevelSpec::parse(text);
        if (!spec.ok())
          return spec.status();
        options.*field = text;
        return {};
      },
      [=](const Options& options) { return options.*field; });
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::spec(std::string Options::*field,
                                                         double minimum, double maximum) {
  row_.minimum = minimum;
  if (maximum < std::numeric_limits<double>::infinity())
    row_.maximum = maximum;
  return spec(field);
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::choice(std::string Options::*field,
                                                           std::vector<Choice> choices) {
  row_.choices = std::move(choices);
  return custom(
      OptionType::choice,
      [field, known = row_.choices](Options& options, const std::string& text) -> Status {
        for (const Choice& choice : known) {
          if (!equalIgnoringCase(choice.name, text))
            continue;
          options.*field = choice.name;
          return {};
        }
        return expected(namesOf(known));
      },
      [=](const Options& options) { return options.*field; });
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::list(std::vector<std::string> Options::*field,
                                                         OptionType type) {
  row_.repeatable = true;
  return custom(
      type,
      [=](Options& options, const std::string& text) -> Status {
        QMESH_RETURN_IF_ERROR(type == OptionType::keyValue ? checkKeyValue(text)
                                                           : checkNotEmpty(text));
        (options.*field).push_back(text);
        return {};
      },
      [=](const Options& options) { return join(options.*field, ", "); });
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::noEffect(std::string why, int values) {
  row_.ignored = std::move(why);
  row_.values = values;
  row_.notInDriver = true;
  return custom(
      values == 0 ? OptionType::flag : OptionType::text,
      [](Options&, const std::string&) { return Status(); },
      [](const Options&) { return std::string(); });
}

template <class Options>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::request(Request request) {
  noEffect("");
  row_.request = request;
  return commandLineOnly();
}

} // namespace qmesh
