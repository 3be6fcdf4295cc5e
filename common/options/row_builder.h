// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/text.h"
#include "options/build_options.h"
#include "options/option_row.h"

namespace qmesh {

/// Fills one OptionRow, so that a row of the table reads as one sentence. A function that names a
/// field also sets the type, the reader and the writer. `Options`: the struct the fields are of, a
/// BuildOptions or one derived from it; instances for each are made in row_builder.cpp.
template <class Options> class BasicRowBuilder {
 public:
  BasicRowBuilder(OptionGroup group, std::string name, char letter = 0);
  operator OptionRow() const { return row_; } // NOLINT

  BasicRowBuilder& alias(std::string name);
  BasicRowBuilder& value(std::string placeholder);
  BasicRowBuilder& unit(std::string unit);
  BasicRowBuilder& help(std::string sentence);
  BasicRowBuilder& whenUnset(std::string text);
  BasicRowBuilder& refusal(std::string text);
  BasicRowBuilder& position(int n);
  BasicRowBuilder& advanced();
  /// Words its value takes on a command line.
  BasicRowBuilder& words(int n);
  /// Shown as the choices of a number that goes by doubling.
  BasicRowBuilder& powersOfTwo(int first, int last);

  /// No value: on where named, off after "--no-NAME".
  BasicRowBuilder& flag(bool Options::*field);
  /// A value, on or off.
  BasicRowBuilder& onOff(bool Options::*field);
  /// Any text of a type without a grammar of its own; `mayBeEmpty` where "" means something.
  BasicRowBuilder& text(std::string Options::*field, OptionType type, bool mayBeEmpty = false);
  /// A number per zoom (LevelSpec), kept as text.
  BasicRowBuilder& spec(std::string Options::*field);
  /// The same with the range its values must lie in at every zoom of a run (checkSpecs()).
  BasicRowBuilder& spec(std::string Options::*field, double minimum, double maximum);
  /// One of the names.
  BasicRowBuilder& choice(std::string Options::*field, std::vector<Choice> choices);
  /// Adds a text at each use.
  BasicRowBuilder& list(std::vector<std::string> Options::*field, OptionType type);
  /// A grammar of its own.
  BasicRowBuilder& custom(OptionType type, std::function<Status(Options&, const std::string&)> set,
                          std::function<std::string(const Options&)> get);
  /// Read and without effect; `why` is part of the warning, empty for none. `values` is 0 or 1.
  BasicRowBuilder& noEffect(std::string why, int values = 0);
  /// Asks for something else than a build.
  BasicRowBuilder& request(Request request);
  BasicRowBuilder& commandLineOnly();
  /// No creation option of the GDAL driver; `instead`: gdal_translate's own option for it.
  BasicRowBuilder& notInDriver(std::string instead = "");

  /// A whole number in a range, any int by default; Field is int, std::int64_t or an optional of
  /// one. Owner is Options or a base of it, here and below.
  template <class Field, class Owner>
  BasicRowBuilder& integer(Field Owner::*field, std::int64_t minimum,
                           std::int64_t maximum = std::numeric_limits<int>::max());

  /// A number in a range; Field is double or an optional of it.
  template <class Field, class Owner>
  BasicRowBuilder& number(Field Owner::*field, double minimum, double maximum);

  /// One of the names of an enum.
  template <class E, class Owner, class = std::enable_if_t<std::is_enum_v<E>>>
  BasicRowBuilder& choice(E Owner::*field);

 private:
  OptionRow row_;
};

/// For the rows of gdal2qmesh, and for those that other programs share with it.
using RowBuilder = BasicRowBuilder<BuildOptions>;

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

template <class Options>
template <class Field, class Owner>
BasicRowBuilder<Options>&
BasicRowBuilder<Options>::integer(Field Owner::*field, std::int64_t minimum, std::int64_t maximum) {
  row_.minimum = static_cast<double>(minimum);
  if (maximum < std::numeric_limits<int>::max())
    row_.maximum = static_cast<double>(maximum);
  return custom(
      OptionType::integer,
      [=](Options& options, const std::string& text) -> Status {
        const Result<std::int64_t> value = parseIntegerIn(text, minimum, maximum);
        if (!value.ok())
          return value.status();
        if constexpr (std::is_integral_v<Field>)
          options.*field = static_cast<Field>(*value);
        else
          options.*field = static_cast<typename Field::value_type>(*value);
        return {};
      },
      [=](const Options& options) { return fieldText(options.*field); });
}

template <class Options>
template <class Field, class Owner>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::number(Field Owner::*field, double minimum,
                                                           double maximum) {
  row_.minimum = minimum;
  row_.maximum = maximum;
  return custom(
      OptionType::number,
      [=](Options& options, const std::string& text) -> Status {
        const Result<double> value = parseNumberIn(text, minimum, maximum);
        if (!value.ok())
          return value.status();
        options.*field = *value;
        return {};
      },
      [=](const Options& options) { return fieldText(options.*field); });
}

template <class Options>
template <class E, class Owner, class>
BasicRowBuilder<Options>& BasicRowBuilder<Options>::choice(E Owner::*field) {
  row_.choices = enumChoices<E>();
  const std::string names = namesOf(row_.choices);
  return custom(
      OptionType::choice,
      [=](Options& options, const std::string& text) -> Status {
        const std::optional<E> value = enumValue<E>(text);
        if (!value)
          return expected(names);
        options.*field = *value;
        return {};
      },
      [=](const Options& options) { return std::string(enumName(options.*field)); });
}

} // namespace qmesh
