// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <utility>

namespace qmesh {

/// What became of an operation. The numbers are the exit codes of the commands (promise P8).
enum class Code {
  ok = 0,          ///< done
  internal = 1,    ///< a fault of ours
  usage = 2,       ///< an option is unknown, malformed or out of range
  interrupted = 3, ///< stopped by the user
  input = 4,       ///< the input cannot be used
  output = 5,      ///< the output cannot be written, is full or is already there
  refused = 6,     ///< resume or update refused
};

/// A code with one sentence for the user: what is wrong, with which file, and the cure.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Code code, std::string message) : code_(code), message_(std::move(message)) {}

  bool ok() const { return code_ == Code::ok; }
  Code code() const { return code_; }
  const std::string& message() const { return message_; }

 private:
  Code code_ = Code::ok;
  std::string message_;
};

/// A value or the status that explains why there is none; never both.
template <class T> class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}                                 // NOLINT
  Result(Status status) : status_(std::move(status)) { assert(!status_.ok()); } // NOLINT

  bool ok() const { return value_.has_value(); }
  const Status& status() const { return status_; }

  /// REQUIRES: ok().
  T& operator*() & { return *value_; }
  const T& operator*() const& { return *value_; }
  T&& operator*() && { return std::move(*value_); }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }

 private:
  std::optional<T> value_;
  Status status_;
};

} // namespace qmesh

/// Returns from the calling function with the status of `expression` unless it is ok.
#define QMESH_RETURN_IF_ERROR(expression)                                                          \
  do {                                                                                             \
    ::qmesh::Status qmesh_status_ = (expression);                                                  \
    if (!qmesh_status_.ok())                                                                       \
      return qmesh_status_;                                                                        \
  } while (false)
