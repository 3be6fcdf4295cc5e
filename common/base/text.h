// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Numbers and words as text, the same in every locale.
namespace qmesh {

/// The whole of `text` as a decimal number ("-1.5", "3e2", "nan", "inf"); nothing where a character
/// is left over, the text is empty or the number does not fit a double.
std::optional<double> parseNumber(std::string_view text);

/// The whole of `text` as a decimal whole number; nothing where it is not one or does not fit.
std::optional<std::int64_t> parseInteger(std::string_view text);

/// A whole number of digits alone, below `end`, which is at most 2^32.
std::optional<std::uint32_t> parseNumberBelow(std::string_view text, std::int64_t end);

/// The shortest text that parseNumber() turns into `value` again; whole numbers below 1e15 without
/// an exponent.
std::string formatNumber(double value);

/// "1 to 5 m", "1 or more m", "m" or nothing: a range with its unit.
std::string rangeText(const std::optional<double>& minimum, const std::optional<double>& maximum,
                      const std::string& unit);

/// Without blanks (space, tab, carriage return, line feed) at both ends.
std::string_view trimmed(std::string_view text);

/// True where two ASCII texts differ in upper and lower case at most.
bool equalIgnoringCase(std::string_view a, std::string_view b);

/// The pieces between separators, empty ones included; one empty piece for an empty text.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The pieces with `separator` between them.
std::string join(const std::vector<std::string>& pieces, std::string_view separator);

/// `text` as a JSON string, with its quotes. Bytes that are not UTF-8 become U+FFFD.
std::string jsonString(std::string_view text);

/// `text` as it must stand in XML or HTML, in attributes too.
std::string escapeMarkup(std::string_view text);

} // namespace qmesh
