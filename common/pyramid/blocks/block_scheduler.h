// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>

namespace qmesh {

/// Decides which block of a pass a thread does next. No order can change a value of the result.
/// The threads of a pass call next() at once.
class BlockScheduler {
 public:
  virtual ~BlockScheduler() = default;

  /// A pass over blocks 0..count-1 begins; no thread works yet.
  virtual void begin(std::size_t count) = 0;
  /// A block that nobody has been given yet; nothing when there is none left for this thread.
  virtual std::optional<std::size_t> next() = 0;
  /// Blocks of the pass that have been given out, for the progress.
  virtual std::size_t given() const = 0;
};

/// One block after the other, to the threads of one process.
class SequentialScheduler : public BlockScheduler {
 public:
  void begin(std::size_t count) override {
    count_ = count;
    next_ = 0;
  }
  std::optional<std::size_t> next() override {
    const std::size_t k = next_++;
    return k < count_ ? std::optional<std::size_t>(k) : std::nullopt;
  }
  std::size_t given() const override { return std::min(next_.load(), count_); }

 private:
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_{0};
};

} // namespace qmesh
