// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstddef>
#include <list>
#include <unordered_map>
#include <utility>

namespace qmesh {

/// Keeps values up to a sum of costs; those not asked for the longest go first. Not thread-safe.
template <class Key, class Value, class Hash = std::hash<Key>> class LruCache {
 public:
  explicit LruCache(std::size_t capacity) : capacity_(capacity) {}

  /// Null where there is none; valid until the next call of put().
  const Value* find(const Key& key) {
    const auto found = places_.find(key);
    if (found == places_.end())
      return nullptr;
    entries_.splice(entries_.begin(), entries_, found->second);
    return &found->second->value;
  }

  /// REQUIRES: the key is not there. A value that costs more than the capacity is alone.
  void put(const Key& key, Value value, std::size_t cost) {
    while (!entries_.empty() && used_ + cost > capacity_) {
      used_ -= entries_.back().cost;
      places_.erase(entries_.back().key);
      entries_.pop_back();
    }
    entries_.push_front({key, std::move(value), cost});
    places_[key] = entries_.begin();
    used_ += cost;
  }

  std::size_t used() const { return used_; }

 private:
  struct Entry {
    Key key;
    Value value;
    std::size_t cost;
  };

  std::size_t capacity_;
  std::size_t used_ = 0;
  std::list<Entry> entries_; ///< the one asked for last first
  std::unordered_map<Key, typename std::list<Entry>::iterator, Hash> places_;
};

} // namespace qmesh
