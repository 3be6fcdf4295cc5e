// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace qmesh {

namespace {

template <class T> std::optional<T> parseWhole(std::string_view text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end)
    return std::nullopt;
  return value;
}

char lowerAscii(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Bytes of the well-formed UTF-8 sequence `text` starts with, 0 where it is malformed (RFC 3629:
/// no overlong forms, no surrogates, at most U+10FFFF).
std::size_t utf8Length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80)
    return 1;
  if (first < 0xC2 || first > 0xF4)
    return 0;
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (length > text.size())
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80)
      return 0;
  const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool surrogate = first == 0xED && byte(1) >= 0xA0;
  const bool tooLarge = first == 0xF4 && byte(1) >= 0x90;
  if (overlong || surrogate || tooLarge)
    return 0;
  return length;
}

std::string jsonEscape(char c) {
  switch (c) {
  case '"':
    return "\\\"";
  case '\\':
    return "\\\\";
  case '\n':
    return "\\n";
  case '\r':
    return "\\r";
  case '\t':
    return "\\t";
  default:
    break;
  }
  const char* digits = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  return std::string("\\u00") + digits[byte >> 4] + digits[byte & 15];
}

} // namespace

std::optional<double> parseNumber(std::string_view text) {
  return parseWhole<double>(text);
}

std::optional<std::int64_t> parseInteger(std::string_view text) {
  return parseWhole<std::int64_t>(text);
}

std::optional<std::uint32_t> parseNumberBelow(std::string_view text, std::int64_t end) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == text.npos;
  const auto number = digits ? parseInteger(text) : std::nullopt;
  return number && *number < end ? std::optional<std::uint32_t>(std::uint32_t(*number))
                                 : std::nullopt;
}

std::string formatNumber(double value) {
  constexpr double kFixedBelow = 1e15;
  std::array<char, 32> buffer;
  char* end = buffer.data() + buffer.size();
  const bool fixed = std::abs(value) < kFixedBelow && value == std::floor(value);
  end = fixed ? std::to_chars(buffer.data(), end, value, std::chars_format::fixed).ptr
              : std::to_chars(buffer.data(), end, value).ptr;
  return std::string(buffer.data(), end);
}

std::string_view trimmed(std::string_view text) {
  const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  for (;;) {
    const std::size_t end = text.find(separator);
    pieces.push_back(text.substr(0, end));
    if (end == std::string_view::npos)
      return pieces;
    text.remove_prefix(end + 1);
  }
}

namespace {

/// 1/3 for 0.333...: a limit that no short decimal number equals is the inverse of a whole number.
std::string limitText(double value) {
  constexpr std::size_t kLong = 10;
  const std::string text = formatNumber(value);
  return text.size() > kLong ? "1/" + formatNumber(std::round(1 / value)) : text;
}

} // namespace

std::string rangeText(const std::optional<double>& minimum, const std::optional<double>& maximum,
                      const std::string& unit) {
  std::string text;
  if (minimum) {
    text = limitText(*minimum);
    text += maximum ? " to " + limitText(*maximum) : " or more";
  }
  return text.empty() || unit.empty() ? text + unit : text + " " + unit;
}

std::string join(const std::vector<std::string>& pieces, std::string_view separator) {
  std::string joined;
  for (const std::string& piece : pieces) {
    if (&piece != pieces.data())
      joined += separator;
    joined += piece;
  }
  return joined;
}

std::string jsonString(std::string_view text) {
  std::string json = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    const auto byte = static_cast<unsigned char>(text[0]);
    if (length == 0) {
      json += "\\ufffd";
    } else if (length == 1 && (byte < 0x20 || byte == 0x7F || byte == '"' || byte == '\\')) {
      json += jsonEscape(text[0]);
    } else {
      json += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return json + '"';
}

bool equalIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lowerAscii(x) == lowerAscii(y); });
}

std::string escapeMarkup(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    case '\'':
      out += "&apos;";
      break;
    default:
      out += c;
    }
  }
  return out;
}

} // namespace qmesh
