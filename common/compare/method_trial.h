// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "compare/compare.h"
#include "grid/node_window.h"
#include "simplify/method_specs.h"
#include "simplify/simplifier.h"

namespace qmesh {

/// What a search looks at.
struct TrialOutcome {
  std::uint64_t triangles = 0;
  double maxError = 0; ///< metres
};

/// Tries one method on a few tiles with different values of one option.
class MethodTrial {
 public:
  /// `windows`: one tile each, voids filled; they and the input live as long as this. `option` is
  /// a SPEC of the method, empty for none.
  MethodTrial(const std::vector<NodeWindow>& windows, const TilesetInput& input,
              const SimplifierInfo& info, const std::string& option);

  /// The arguments of a search and what they mean: a percentage that is taken away is searched for
  /// by what is left.
  struct Scale {
    double low = 0;
    double high = 0;
    double takenFrom = 0; ///< 0: the argument is the value; else the value is this less it

    std::string valueText(double x) const;
  };

  bool canBeTuned() const { return option_ != nullptr; }
  Scale scale() const;

  /// The method with the option at a value; empty: with the run's options.
  Result<TrialOutcome> run(const std::string& value);

  /// The same with everything that is told of it.
  Result<ComparedMethod> measure(const std::string& value);

 private:
  struct Setting {
    MethodOptions options;
    LevelParams level;
  };
  Result<Setting> settingAt(const std::string& value) const;
  Result<TrialOutcome> runTiles(const Setting& setting, ComparedMethod* row) const;

  const std::vector<NodeWindow>& windows_;
  const TilesetInput& input_;
  const SimplifierInfo& info_;
  const MethodSpec* option_; ///< null: none
};

} // namespace qmesh
