// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <stdexcept>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

namespace qmesh {

/// The option structs of one program, found by their type, so that each struct has its rows once
/// and a program takes the rows of the structs it has. A view: lives no longer than the structs.
/// `Void` is void, or const void for structs that are only read.
template <class Void> class BasicOptionStructs {
 public:
  template <class... Structs> static BasicOptionStructs of(Structs&... structs) {
    BasicOptionStructs all;
    all.structs_ = {{std::type_index(typeid(Structs)), &structs}...};
    return all;
  }

  /// Throws std::logic_error where the program has no such struct: a row of it is in the wrong
  /// table.
  template <class Struct> auto& get() const {
    using Found = std::conditional_t<std::is_const_v<Void>, const Struct, Struct>;
    for (const auto& [type, address] : structs_)
      if (type == std::type_index(typeid(Struct)))
        return *static_cast<Found*>(address);
    throw std::logic_error("a row of an option struct that the program does not have");
  }

 private:
  std::vector<std::pair<std::type_index, Void*>> structs_;
};

using OptionStructs = BasicOptionStructs<void>;
using ConstOptionStructs = BasicOptionStructs<const void>;

} // namespace qmesh
