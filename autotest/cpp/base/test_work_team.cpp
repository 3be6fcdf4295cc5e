// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "base/work_team.h"

#include <gtest/gtest.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/in_order.h"

namespace qmesh {
namespace {

/// The numbers 0..count-1 doubled by inOrder(), as they are taken.
Result<std::vector<int>> doubled(int threads, int count, int throwAt = -1) {
  int next = 0;
  std::vector<int> taken;
  const Status status = inOrder(
      threads, [&]() { return next < count ? std::optional<int>(next++) : std::nullopt; },
      [&](int item, int thread) {
        EXPECT_GE(thread, 0);
        EXPECT_LT(thread, threads);
        if (item == throwAt)
          throw std::runtime_error("item " + std::to_string(item));
        return 2 * item;
      },
      [&](int item, int result) {
        EXPECT_EQ(result, 2 * item);
        taken.push_back(result);
        return Status();
      });
  if (!status.ok())
    return status;
  return taken;
}

TEST(InOrder, TakesResultsInTheOrderOfTheItems) {
  for (const int threads : {1, 2, 5}) {
    const auto taken = doubled(threads, 1000);
    ASSERT_TRUE(taken.ok());
    ASSERT_EQ(taken->size(), 1000u);
    for (int k = 0; k < 1000; ++k)
      ASSERT_EQ((*taken)[std::size_t(k)], 2 * k);
  }
}

TEST(InOrder, AnExceptionIsAStatus) {
  for (const int threads : {1, 2, 5}) {
    const auto taken = doubled(threads, 300, 217);
    ASSERT_FALSE(taken.ok());
    EXPECT_EQ(taken.status().code(), Code::internal);
    EXPECT_NE(taken.status().message().find("item 217"), std::string::npos);
  }
}

TEST(WorkTeam, TheFirstFailureStopsTheOthers) {
  std::atomic<bool> stop{false};
  const Progress none;
  WorkTeam team(stop, none, [] {});
  std::atomic<int> turn{0};
  const Status status = team.run(
      3,
      [&]() -> Status {
        if (turn++ == 1)
          throw std::bad_alloc();
        while (!stop) {
        }
        return {};
      },
      [] { return 0.0; });
  EXPECT_EQ(status.code(), Code::internal);
  EXPECT_NE(status.message().find("not enough memory"), std::string::npos);
}

// A limit of processes does not bind root, so the test gives up that right in a child.
TEST(WorkTeam, WorksWithTheThreadsThatCanBeMade) {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit none{0, 0};
    const bool limited =
        setrlimit(RLIMIT_NPROC, &none) == 0 && (geteuid() != 0 || setuid(65534) == 0);
    const auto taken = doubled(4, 100);
    _exit(limited && taken.ok() && taken->size() == 100 ? 0 : 1);
  }
  int state = 0;
  waitpid(child, &state, 0);
  EXPECT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 0);
}

} // namespace
} // namespace qmesh
