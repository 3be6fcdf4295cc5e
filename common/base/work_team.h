// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <utility>

#include "base/progress.h"
#include "base/status.h"

namespace qmesh {

/// Threads that do one piece of a run at a time while the calling thread tells the progress.
class WorkTeam {
 public:
  /// `stop` is set when a member fails or `progress` says so; members look at it. `enter` is the
  /// first that each of them does.
  WorkTeam(std::atomic<bool>& stop, const Progress& progress, std::function<void()> enter)
      : stop_(stop), progress_(progress), enter_(std::move(enter)) {}

  /// Runs `work` in so many threads and waits for all. `done` is asked for the progress, 0..1,
  /// while they work. The first failure (of an exception: Code::internal), or Code::interrupted
  /// where `progress` stopped the work.
  Status run(std::size_t threads, const std::function<Status()>& work,
             const std::function<double()>& done);

 private:
  Status workSafely(const std::function<Status()>& work) const;
  void watch(const std::function<double()>& done);
  void finish(const Status& status);

  std::atomic<bool>& stop_;
  const Progress& progress_;
  std::function<void()> enter_;
  std::mutex mutex_; ///< guards what follows
  std::condition_variable finished_;
  Status status_;
  std::size_t running_ = 0;
  bool interrupted_ = false;
};

} // namespace qmesh
