// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/text.h"
#include "options/option_row.h"

namespace qmesh {

/// Fills one OptionRow, so that a row of the table reads as one sentence. A function that names a
/// field also sets the type, the reader and the writer.
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
  RowBuilder& advanced();
  /// Words its value takes on a command line.
  RowBuilder& words(int n);
  /// Shown as the choices of a number that goes by doubling.
  RowBuilder& powersOfTwo(int first, int last);

  /// No value: on where named, off after "--no-NAME".
  RowBuilder& flag(bool BuildOptions::*field);
  /// A value, on or off.
  RowBuilder& onOff(bool BuildOptions::*field);
  /// Any text of a type without a grammar of its own; `mayBeEmpty` where "" means something.
  RowBuilder& text(std::string BuildOptions::*field, OptionType type, bool mayBeEmpty = false);
  /// A number per zoom (LevelSpec), kept as text.
  RowBuilder& spec(std::string BuildOptions::*field);
  /// The same with the range its values must lie in at every zoom of a run (checkSpecs()).
  RowBuilder& spec(std::string BuildOptions::*field, double minimum, double maximum);
  /// One of the names.
  RowBuilder& choice(std::string BuildOptions::*field, std::vector<Choice> choices);
  /// Adds a text at each use.
  RowBuilder& list(std::vector<std::string> BuildOptions::*field, OptionType type);
  /// A grammar of its own.
  RowBuilder& custom(OptionType type, decltype(OptionRow::set) set, decltype(OptionRow::get) get);
  /// Read and without effect; `why` is part of the warning, empty for none. `values` is 0 or 1.
  RowBuilder& noEffect(std::string why, int values = 0);
  /// Asks for something else than a build.
  RowBuilder& request(Request request);
  RowBuilder& commandLineOnly();

  /// A whole number in a range, any int by default; Field is int, std::int64_t or an optional of
  /// one. Owner is BuildOptions or a base of it, here and below.
  template <class Field, class Owner>
  RowBuilder& integer(Field Owner::*field, std::int64_t minimum,
                      std::int64_t maximum = std::numeric_limits<int>::max());

  /// A number in a range; Field is double or an optional of it.
  template <class Field, class Owner>
  RowBuilder& number(Field Owner::*field, double minimum, double maximum);

  /// One of the names of an enum.
  template <class E, class Owner, class = std::enable_if_t<std::is_enum_v<E>>>
  RowBuilder& choice(E Owner::*field);

 private:
  OptionRow row_;
};

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

template <class Field, class Owner>
RowBuilder& RowBuilder::integer(Field Owner::*field, std::int64_t minimum, std::int64_t maximum) {
  row_.minimum = static_cast<double>(minimum);
  if (maximum < std::numeric_limits<int>::max())
    row_.maximum = static_cast<double>(maximum);
  return custom(
      OptionType::integer,
      [=](BuildOptions& options, const std::string& text) -> Status {
        const Result<std::int64_t> value = parseIntegerIn(text, minimum, maximum);
        if (!value.ok())
          return value.status();
        if constexpr (std::is_integral_v<Field>)
          options.*field = static_cast<Field>(*value);
        else
          options.*field = static_cast<typename Field::value_type>(*value);
        return {};
      },
      [=](const BuildOptions& options) { return fieldText(options.*field); });
}

template <class Field, class Owner>
RowBuilder& RowBuilder::number(Field Owner::*field, double minimum, double maximum) {
  row_.minimum = minimum;
  row_.maximum = maximum;
  return custom(
      OptionType::number,
      [=](BuildOptions& options, const std::string& text) -> Status {
        const Result<double> value = parseNumberIn(text, minimum, maximum);
        if (!value.ok())
          return value.status();
        options.*field = *value;
        return {};
      },
      [=](const BuildOptions& options) { return fieldText(options.*field); });
}

template <class E, class Owner, class> RowBuilder& RowBuilder::choice(E Owner::*field) {
  row_.choices = enumChoices<E>();
  const std::string names = namesOf(row_.choices);
  return custom(
      OptionType::choice,
      [=](BuildOptions& options, const std::string& text) -> Status {
        const std::optional<E> value = enumValue<E>(text);
        if (!value)
          return expected(names);
        options.*field = *value;
        return {};
      },
      [=](const BuildOptions& options) { return std::string(enumName(options.*field)); });
}

} // namespace qmesh
