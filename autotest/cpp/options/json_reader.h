// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace qmesh {

/// A value of a JSON text, for tests.
struct Json {
  enum class Kind { null, boolean, number, text, array, object } kind = Kind::null;
  bool boolean = false;
  double number = 0;
  std::string text;
  std::vector<Json> items;
  std::map<std::string, Json> members;

  bool has(const std::string& key) const { return members.count(key) > 0; }
  const Json& operator[](const std::string& key) const { return members.at(key); }
};

/// A strict reader (RFC 8259) that throws std::runtime_error on anything else than one JSON value.
/// Keys may not repeat; \u escapes stay as they are.
class JsonReader {
 public:
  explicit JsonReader(const std::string& text) : text_(text) {}

  Json read() {
    Json value = readValue();
    skipBlanks();
    if (at_ != text_.size())
      fail("text after the value");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(what + " at byte " + std::to_string(at_));
  }

  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skipBlanks() {
    while (peek() == ' ' || peek() == '\n' || peek() == '\t' || peek() == '\r')
      ++at_;
  }

  bool take(char c) {
    skipBlanks();
    if (peek() != c)
      return false;
    ++at_;
    return true;
  }

  void expect(char c) {
    if (!take(c))
      fail(std::string("expected ") + c);
  }

  bool takeWord(const std::string& word) {
    if (text_.compare(at_, word.size(), word) != 0)
      return false;
    at_ += word.size();
    return true;
  }

  Json readValue() {
    skipBlanks();
    Json value;
    if (peek() == '{')
      return readObject();
    if (peek() == '[')
      return readArray();
    if (peek() == '"') {
      value.kind = Json::Kind::text;
      value.text = readString();
    } else if (takeWord("true") || takeWord("false")) {
      value.kind = Json::Kind::boolean;
      value.boolean = text_[at_ - 2] == 'u';
    } else if (!takeWord("null")) {
      value.kind = Json::Kind::number;
      value.number = readNumber();
    }
    return value;
  }

  Json readObject() {
    Json object;
    object.kind = Json::Kind::object;
    expect('{');
    if (take('}'))
      return object;
    do {
      skipBlanks();
      const std::string key = readString();
      expect(':');
      if (!object.members.emplace(key, readValue()).second)
        fail("key twice: " + key);
    } while (take(','));
    expect('}');
    return object;
  }

  Json readArray() {
    Json array;
    array.kind = Json::Kind::array;
    expect('[');
    if (take(']'))
      return array;
    do
      array.items.push_back(readValue());
    while (take(','));
    expect(']');
    return array;
  }

  std::string readString() {
    if (peek() != '"')
      fail("expected a string");
    std::string value;
    for (++at_; peek() != '"'; ++at_) {
      if (at_ >= text_.size() || static_cast<unsigned char>(peek()) < 0x20)
        fail("unfinished string");
      if (peek() == '\\')
        value += readEscape();
      else
        value += peek();
    }
    ++at_;
    return value;
  }

  std::string readEscape() {
    const std::string escapes = "\"\\/bfnrt";
    const std::string meanings = "\"\\/\b\f\n\r\t";
    ++at_;
    if (const std::size_t i = escapes.find(peek()); peek() != '\0' && i != std::string::npos)
      return meanings.substr(i, 1);
    if (peek() != 'u' ||
        text_.substr(at_ + 1, 4).find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
      fail("unknown escape");
    at_ += 4;
    return text_.substr(at_ - 5, 6);
  }

  double readNumber() {
    std::size_t end = text_.find_first_not_of("-+.eE0123456789", at_);
    end = end == std::string::npos ? text_.size() : end;
    const std::string digits = text_.substr(at_, end - at_);
    std::size_t used = 0;
    if (digits.empty() || digits[0] == '+' || digits[0] == '.')
      fail("expected a value");
    const double value = std::stod(digits, &used);
    if (used != digits.size())
      fail("malformed number");
    at_ = end;
    return value;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

} // namespace qmesh
