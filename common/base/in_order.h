// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <atomic>
#include <optional>
#include <utility>
#include <vector>

#include "base/status.h"
#include "base/work_team.h"

namespace qmesh {

/// Runs work on a stream of items in several threads and takes the results in the order of the
/// items, so that the outcome does not depend on the threads. Items are worked on in batches: all
/// threads end a batch before its results are taken.
///   next()                    an optional item, in the calling thread; nothing ends the stream
///   work(item, thread)        the result, in thread 0..threads-1
///   take(item, result)        a Status, in the calling thread; a fault ends the stream
/// An exception in work() ends the stream with Code::internal. One thread is the calling thread.
template <class Next, class Work, class Take>
Status inOrder(int threads, Next next, Work work, Take take) {
  using Item = typename decltype(next())::value_type;
  using Made = decltype(work(std::declval<const Item&>(), 0));
  const std::size_t batch = std::size_t(threads) * (threads > 1 ? 32 : 1);
  while (true) {
    std::vector<Item> items;
    while (items.size() < batch) {
      std::optional<Item> item = next();
      if (!item)
        break;
      items.push_back(*std::move(item));
    }
    if (items.empty())
      return {};
    std::vector<std::optional<Made>> made(items.size());
    std::atomic<std::size_t> nextItem{0};
    std::atomic<int> nextThread{0};
    std::atomic<bool> stop{false};
    const auto run = [&]() -> Status {
      const int thread = nextThread++;
      for (std::size_t k = nextItem++; k < items.size() && !stop; k = nextItem++)
        made[k].emplace(work(items[k], thread));
      return {};
    };
    if (threads > 1)
      QMESH_RETURN_IF_ERROR(
          WorkTeam(stop, Progress(), [] {}).run(std::size_t(threads), run, [] { return 0.0; }));
    else
      QMESH_RETURN_IF_ERROR(WorkTeam::safely(run));
    for (std::size_t k = 0; k < items.size(); ++k)
      QMESH_RETURN_IF_ERROR(take(items[k], *std::move(made[k])));
  }
}

} // namespace qmesh
