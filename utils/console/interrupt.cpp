// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "console/interrupt.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>

#include "base/status.h"

namespace qmesh {

namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not lock");

/// Seconds in which a further signal counts as the same one: timeout(1) and terminals signal the
/// process and its group.
constexpr time_t kSameSignal = 1;

std::atomic<time_t> stopTime{0};

/// The first signal asks for a clean stop, one that comes later for an immediate one.
void requestStop(int) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (!stop.exchange(true))
    stopTime = now.tv_sec;
  else if (now.tv_sec - stopTime > kSameSignal)
    _exit(static_cast<int>(Code::interrupted));
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART; // no read or write of a library fails with EINTR
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

} // namespace

void installSignalHandlers() {
  handle(SIGINT, requestStop);
  handle(SIGTERM, requestStop);
  handle(SIGHUP, requestStop);
  handle(SIGXFSZ, SIG_IGN);
  handle(SIGPIPE, SIG_IGN);
}

bool stopRequested() {
  return stop;
}

} // namespace qmesh
