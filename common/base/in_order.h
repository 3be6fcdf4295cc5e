// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <atomic>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "base/status.h"

namespace qmesh {

/// Does work on a stream of items with several threads and takes the results in the order of the
/// items, so that what comes out does not depend on the threads. Items are worked on in batches:
/// all threads end a batch before its results are taken.
///   next()                    an optional item, from this thread; nothing ends the stream
///   work(item, thread)        the result, from thread 0..threads-1
///   take(item, result)        a Status, from this thread; a fault ends the stream
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
    std::atomic<std::size_t> place{0};
    const auto run = [&](int thread) {
      for (std::size_t k = place++; k < items.size(); k = place++)
        made[k].emplace(work(items[k], thread));
    };
    std::vector<std::thread> others;
    for (int thread = 1; thread < threads; ++thread)
      others.emplace_back(run, thread);
    run(0);
    for (std::thread& other : others)
      other.join();
    for (std::size_t k = 0; k < items.size(); ++k)
      QMESH_RETURN_IF_ERROR(take(items[k], *std::move(made[k])));
  }
}

} // namespace qmesh
