// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/enum_table.h"
#include "base/text.h"
#include "options/option_row.h"
#include "tiling/level_spec.h"

namespace qmesh {

/// "expected WHAT" as a usage status.
Status expected(const std::string& what);

/// "a, b or c".
std::string namesOf(const std::vector<Choice>& choices);

/// A whole number minimum..maximum; on a fault the status says the range.
Result<std::int64_t> parseIntegerIn(const std::string& text, std::int64_t minimum,
                                    std::int64_t maximum);

/// A number minimum..maximum; on a fault the status says the range.
Result<double> parseNumberIn(const std::string& text, double minimum, double maximum);

template <class T> std::string fieldText(const T& value) {
  if constexpr (std::is_integral_v<T>)
    return std::to_string(value);
  else
    return formatNumber(value);
}
template <class T> std::string fieldText(const std::optional<T>& value) {
  return value ? fieldText(*value) : std::string();
}

/// Fills one OptionRow, so that a row of the table reads as one sentence. A function that names a
/// field also sets the type, the reader and the writer; the field's struct is the one that the row
/// looks for among the structs of a program, and its initialiser is the default.
class RowBuilder {
 public:
  RowBuilder(OptionGroup group, std::string name, char letter = 0);
  operator OptionRow() const { return row_; } // NOLINT

  RowBuilder& alias(std::string name);
  RowBuilder& value(std::string placeholder);
  RowBuilder& unit(std::string unit);
  RowBuilder& help(std::string sentence);
  RowBuilder& whenUnset(std::string text);
  RowBuilder& refusal(std::string text);
  RowBuilder& position(int n);
  /// Shown by -h, too.
  RowBuilder& essential();
  RowBuilder& advanced();
  /// Words its value takes on a command line.
  RowBuilder& words(int n);
  /// Shown as the choices of a number that goes by doubling.
  RowBuilder& powersOfTwo(int first, int last);
  /// Only these methods look at it.
  RowBuilder& methods(std::vector<std::string> names);
  /// Read and without effect; `why` is part of the warning, empty for none. `values` is 0 or 1.
  RowBuilder& noEffect(std::string why, int values = 0);
  /// Asks for something else than a run.
  RowBuilder& request(Request request);
  RowBuilder& commandLineOnly();
  /// No creation option of the GDAL driver; `instead`: gdal_translate's own option for it.
  RowBuilder& notInDriver(std::string instead = "");

  /// No value: on where named, off after "--no-NAME".
  template <class Struct> RowBuilder& flag(bool Struct::*field);
  /// A value, on or off.
  template <class Struct> RowBuilder& onOff(bool Struct::*field);
  /// Any text of a type without a grammar of its own; `mayBeEmpty` where "" means something.
  template <class Struct>
  RowBuilder& text(std::string Struct::*field, OptionType type, bool mayBeEmpty = false);
  /// A number per zoom, each within the range at every zoom of a run: for the help and for forms.
  template <class Struct>
  RowBuilder& spec(LevelSpec Struct::*field, std::optional<double> minimum,
                   std::optional<double> maximum);
  /// One of the names.
  template <class Struct>
  RowBuilder& choice(std::string Struct::*field, std::vector<Choice> choices);
  /// One of the names of an enum.
  template <class E, class Struct, class = std::enable_if_t<std::is_enum_v<E>>>
  RowBuilder& choice(E Struct::*field);
  /// Adds a text at each use.
  template <class Struct>
  RowBuilder& list(std::vector<std::string> Struct::*field, OptionType type);
  /// A whole number in a range, any int by default; Field is int, std::int64_t or an optional of
  /// one.
  template <class Field, class Struct>
  RowBuilder& integer(Field Struct::*field, std::int64_t minimum,
                      std::int64_t maximum = std::numeric_limits<int>::max());
  /// A number in a range; Field is double or an optional of it.
  template <class Field, class Struct>
  RowBuilder& number(Field Struct::*field, double minimum, double maximum);
  /// A grammar of its own: set(Struct&, text) gives a Status, get(const Struct&) the text.
  template <class Struct, class Set, class Get>
  RowBuilder& custom(OptionType type, Set set, Get get);

 private:
  OptionRow row_;
};

/// Readers and writers of single fields; the readers' status says what they expected.
Status setSwitch(bool& field, const std::string& text);
std::string switchText(bool on);
Status setText(std::string& field, const std::string& text, bool mayBeEmpty);
Status setSpec(LevelSpec& field, const std::string& text);
Status setChoice(std::string& field, const std::string& text, const std::vector<Choice>& choices);
Status addToList(std::vector<std::string>& field, const std::string& text, OptionType type);
std::vector<Choice> switchChoices();

template <class Struct, class Set, class Get>
RowBuilder& RowBuilder::custom(OptionType type, Set set, Get get) {
  row_.type = type;
  row_.initial = get(Struct());
  row_.set = [set](const OptionStructs& structs, const std::string& text) -> Status {
    return set(structs.get<Struct>(), text);
  };
  row_.get = [get](const ConstOptionStructs& structs) -> std::string {
    return get(structs.get<Struct>());
  };
  return *this;
}

template <class Struct> RowBuilder& RowBuilder::flag(bool Struct::*field) {
  row_.values = 0;
  return custom<Struct>(
      OptionType::flag,
      [=](Struct& options, const std::string& text) { return setSwitch(options.*field, text); },
      [=](const Struct& options) { return switchText(options.*field); });
}

template <class Struct> RowBuilder& RowBuilder::onOff(bool Struct::*field) {
  flag(field);
  row_.values = 1;
  row_.type = OptionType::choice;
  row_.choices = switchChoices();
  return *this;
}

template <class Struct>
RowBuilder& RowBuilder::text(std::string Struct::*field, OptionType type, bool mayBeEmpty) {
  return custom<Struct>(
      type,
      [=](Struct& options, const std::string& text) {
        return setText(options.*field, text, mayBeEmpty);
      },
      [=](const Struct& options) { return options.*field; });
}

template <class Struct>
RowBuilder& RowBuilder::spec(LevelSpec Struct::*field, std::optional<double> minimum,
                             std::optional<double> maximum) {
  row_.minimum = minimum;
  row_.maximum = maximum;
  return custom<Struct>(
      OptionType::spec,
      [=](Struct& options, const std::string& text) { return setSpec(options.*field, text); },
      [=](const Struct& options) { return (options.*field).text(); });
}

template <class Struct>
RowBuilder& RowBuilder::choice(std::string Struct::*field, std::vector<Choice> choices) {
  row_.choices = std::move(choices);
  return custom<Struct>(
      OptionType::choice,
      [field, known = row_.choices](Struct& options, const std::string& text) {
        return setChoice(options.*field, text, known);
      },
      [=](const Struct& options) { return options.*field; });
}

template <class E, class Struct, class> RowBuilder& RowBuilder::choice(E Struct::*field) {
  row_.choices = enumChoices<E>();
  const std::string names = namesOf(row_.choices);
  return custom<Struct>(
      OptionType::choice,
      [=](Struct& options, const std::string& text) -> Status {
        const std::optional<E> value = enumValue<E>(text);
        if (!value)
          return expected(names);
        options.*field = *value;
        return {};
      },
      [=](const Struct& options) { return std::string(enumName(options.*field)); });
}

template <class Struct>
RowBuilder& RowBuilder::list(std::vector<std::string> Struct::*field, OptionType type) {
  row_.repeatable = true;
  return custom<Struct>(
      type,
      [=](Struct& options, const std::string& text) {
        return addToList(options.*field, text, type);
      },
      [=](const Struct& options) { return join(options.*field, ", "); });
}

template <class Field, class Struct>
RowBuilder& RowBuilder::integer(Field Struct::*field, std::int64_t minimum, std::int64_t maximum) {
  row_.minimum = static_cast<double>(minimum);
  if (maximum < std::numeric_limits<int>::max())
    row_.maximum = static_cast<double>(maximum);
  return custom<Struct>(
      OptionType::integer,
      [=](Struct& options, const std::string& text) -> Status {
        const Result<std::int64_t> value = parseIntegerIn(text, minimum, maximum);
        if (!value.ok())
          return value.status();
        if constexpr (std::is_integral_v<Field>)
          options.*field = static_cast<Field>(*value);
        else
          options.*field = static_cast<typename Field::value_type>(*value);
        return {};
      },
      [=](const Struct& options) { return fieldText(options.*field); });
}

template <class Field, class Struct>
RowBuilder& RowBuilder::number(Field Struct::*field, double minimum, double maximum) {
  row_.minimum = minimum;
  row_.maximum = maximum;
  return custom<Struct>(
      OptionType::number,
      [=](Struct& options, const std::string& text) -> Status {
        const Result<double> value = parseNumberIn(text, minimum, maximum);
        if (!value.ok())
          return value.status();
        options.*field = *value;
        return {};
      },
      [=](const Struct& options) { return fieldText(options.*field); });
}

} // namespace qmesh
