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

/// The threads of a program: they do one piece of work at a time while the calling thread reports
/// the progress. No exception leaves a thread, and fewer threads do the work where the system makes
/// no more.
class WorkTeam {
 public:
  /// `stop` is set when a thread fails or `progress` returns false; the work must check it. Each
  /// thread calls `enter` first. `stop` and `progress` must outlive this.
  WorkTeam(std::atomic<bool>& stop, const Progress& progress, std::function<void()> enter)
      : stop_(stop), progress_(progress), enter_(std::move(enter)) {}

  /// Runs `work` in `threads` threads and waits for all; in the calling thread where the system
  /// makes none. `done` gives the progress meanwhile, 0..1. Returns the first failure (an exception
  /// is Code::internal), or Code::interrupted where `progress` stopped the work.
  Status run(std::size_t threads, const std::function<Status()>& work,
             const std::function<double()>& done);

  /// The status of `work`; Code::internal where it throws.
  static Status safely(const std::function<Status()>& work);

 private:
  Status enterAndWork(const std::function<Status()>& work) const;
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
