// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>

namespace qmesh {

/// gdal2tiles' progress, "0...10...20...", as text to print piece by piece. Where `rewrite` is set
/// the line is printed anew each time, after "\r", with the time left: for a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool rewrite) : rewrite_(rewrite) {}

  /// What to print now that `done` (0..1) is done after `seconds`; empty where nothing changed. The
  /// call that says 1 ends the line with "100 - done."; calls after it say nothing.
  std::string update(double done, double seconds);

  /// Whether something was printed and the line has not ended.
  bool open() const { return ticks_ >= 0 && ticks_ < kTicks; }

 private:
  static constexpr int kTicks = 40; ///< a number every 10 %, three dots between

  bool rewrite_;
  int ticks_ = -1;          ///< printed so far; -1: none, not even the 0
  double printed_ = 0;      ///< seconds at the last print
  std::size_t longest_ = 0; ///< characters to wipe when the line is printed anew
};

/// "12 s", "3 min 20 s", "1 h 05 min".
std::string durationText(double seconds);

/// What a command says: messages and progress on stdout (or where `out` says: a command whose
/// results go there keeps it clean), warnings and errors on stderr. For one thread.
class Console {
 public:
  explicit Console(std::string program, std::FILE* out = stdout);

  void setQuiet(bool quiet) { quiet_ = quiet; }
  void setVerbose(bool verbose) { verbose_ = verbose; }

  /// One line, without its end; nothing where quiet.
  void message(const std::string& text);
  /// One line where verbose and not quiet.
  void detail(const std::string& text);
  /// "PROGRAM: warning: TEXT"; nothing where quiet.
  void warning(const std::string& text);
  /// "PROGRAM: error: TEXT".
  void error(const std::string& text);
  /// The usage line before it, as gdal2tiles has it.
  void usageError(const std::string& usage, const std::string& text);

  /// Progress 0..1; the time left is estimated from the first call.
  void progress(double done);
  /// Columns of the terminal for the help: 80 where it writes to none, 100 at most.
  int columns() const;

 private:
  /// Ends an unfinished line of progress, so that a message begins its own; a call of progress()
  /// afterwards prints it from 0 again.
  void endProgress();

  std::string program_;
  std::FILE* out_;
  bool terminal_;
  bool quiet_ = false;
  bool verbose_ = false;
  ProgressLine line_;
  std::optional<std::chrono::steady_clock::time_point> start_; ///< of the first progress
};

} // namespace qmesh
