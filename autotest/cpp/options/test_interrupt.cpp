// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>

#include "console/interrupt.h"

namespace qmesh {
namespace {

constexpr int kAsked = 40; ///< the child's exit code where it was asked to stop and lived on

/// Installs the handlers, raises a signal `times`, with some seconds between, and exits with kAsked
/// where a stop is requested.
[[noreturn]] void raiseAndExit(int signal, int times, unsigned pause = 0) {
  installSignalHandlers();
  if (stopRequested())
    _exit(1);
  for (int i = 0; i < times; ++i) {
    if (i > 0)
      sleep(pause);
    raise(signal);
  }
  _exit(stopRequested() ? kAsked : 0);
}

TEST(InterruptDeathTest, TheFirstSignalAsks) {
  EXPECT_EXIT(raiseAndExit(SIGINT, 1), testing::ExitedWithCode(kAsked), "");
  EXPECT_EXIT(raiseAndExit(SIGTERM, 1), testing::ExitedWithCode(kAsked), "");
  EXPECT_EXIT(raiseAndExit(SIGHUP, 1), testing::ExitedWithCode(kAsked), "");
}

// timeout(1) signals the process and its group.
TEST(InterruptDeathTest, TwiceAtOnceIsOne) {
  EXPECT_EXIT(raiseAndExit(SIGTERM, 2), testing::ExitedWithCode(kAsked), "");
}

TEST(InterruptDeathTest, ALaterOneEndsAtOnce) {
  EXPECT_EXIT(raiseAndExit(SIGINT, 2, 3), testing::ExitedWithCode(3), "");
}

TEST(InterruptDeathTest, AClosedPipeIsAFailedWrite) {
  EXPECT_EXIT(raiseAndExit(SIGPIPE, 1), testing::ExitedWithCode(0), "");
}

/// Writes more than the process may: the write must fail, the process live.
[[noreturn]] void writeTooMuch() {
  installSignalHandlers();
  const rlimit limit = {10, 10};
  char name[] = "/tmp/qmesh_interrupt_XXXXXX";
  const int file = mkstemp(name);
  unlink(name);
  if (file < 0 || setrlimit(RLIMIT_FSIZE, &limit) != 0)
    _exit(1);
  const char bytes[20] = {};
  const ssize_t first = write(file, bytes, sizeof bytes);
  _exit(first == 10 && write(file, bytes, sizeof bytes) == -1 ? kAsked : 2);
}

TEST(InterruptDeathTest, AFullFileIsAFailedWrite) {
  EXPECT_EXIT(writeTooMuch(), testing::ExitedWithCode(kAsked), "");
}

} // namespace
} // namespace qmesh
