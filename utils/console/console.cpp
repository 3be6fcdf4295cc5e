// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "console/console.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace qmesh {

namespace {

/// An estimate before this much of the work (0..1) and time (seconds) is a guess.
constexpr double kEnoughDone = 0.02;
constexpr double kEnoughSeconds = 2;

/// The time left is printed anew this often, seconds.
constexpr double kRewritePeriod = 1;

void print(FILE* stream, const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stream);
  std::fflush(stream);
}

/// What stands at a tick: "0", three dots, "10", ...
std::string tickText(int tick) {
  return tick % 4 == 0 ? std::to_string(tick / 4 * 10) : ".";
}

std::string twoDigits(int number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

} // namespace

std::string durationText(double seconds) {
  const int total = static_cast<int>(std::ceil(std::clamp(seconds, 0.0, 1e9)));
  if (total < 60)
    return std::to_string(total) + " s";
  const int minutes = total / 60;
  if (minutes < 60)
    return std::to_string(minutes) + " min " + twoDigits(total % 60) + " s";
  return std::to_string(minutes / 60) + " h " + twoDigits(minutes % 60) + " min";
}

std::string ProgressLine::update(double done, double seconds) {
  if (ticks_ == kTicks)
    return {};
  const int reached =
      std::max(ticks_, static_cast<int>(std::floor(std::clamp(done, 0.0, 1.0) * kTicks)));
  const bool timePassed = rewrite_ && seconds - printed_ >= kRewritePeriod;
  if (reached == ticks_ && !timePassed)
    return {};
  std::string text;
  for (int tick = rewrite_ ? 0 : ticks_ + 1; tick <= reached; ++tick)
    text += tickText(tick);
  ticks_ = reached;
  printed_ = seconds;
  if (reached == kTicks)
    text += " - done.";
  else if (rewrite_ && done >= kEnoughDone && seconds >= kEnoughSeconds)
    text += " " + durationText(seconds / done * (1 - done)) + " left";
  if (rewrite_) {
    longest_ = std::max(longest_, text.size());
    text = "\r" + text + std::string(longest_ - text.size(), ' ');
  }
  return reached == kTicks ? text + "\n" : text;
}

Console::Console(std::string program, std::FILE* out)
    : program_(std::move(program)), out_(out), terminal_(isatty(fileno(out)) == 1),
      line_(terminal_) {}

void Console::endProgress() {
  if (!line_.open())
    return;
  print(out_, "\n");
  line_ = ProgressLine(terminal_);
}

void Console::message(const std::string& text) {
  if (quiet_)
    return;
  endProgress();
  print(out_, text + "\n");
}

void Console::detail(const std::string& text) {
  if (verbose_)
    message(text);
}

void Console::warning(const std::string& text) {
  if (quiet_)
    return;
  endProgress();
  print(stderr, program_ + ": warning: " + text + "\n");
}

void Console::error(const std::string& text) {
  endProgress();
  print(stderr, program_ + ": error: " + text + "\n");
}

void Console::usageError(const std::string& usage, const std::string& text) {
  print(stderr, usage + "\n");
  error(text);
}

void Console::progress(double done) {
  if (quiet_)
    return;
  const auto now = std::chrono::steady_clock::now();
  if (!start_)
    start_ = now;
  const std::string text = line_.update(done, std::chrono::duration<double>(now - *start_).count());
  if (!text.empty())
    print(out_, text);
}

int Console::columns() const {
  constexpr int kUsual = 80;
  constexpr int kMost = 100;
  winsize size = {};
  if (!terminal_ || ioctl(fileno(out_), TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
    return kUsual;
  return std::min<int>(size.ws_col, kMost);
}

} // namespace qmesh
