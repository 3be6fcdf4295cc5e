// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include <cpl_error.h>

namespace qmesh {

/// While it lives, this thread's GDAL errors are kept here and not printed; other threads and the
/// handler of the host are left alone. Create and destroy in one thread, in scope order.
class QuietErrors {
 public:
  QuietErrors();
  ~QuietErrors();
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

  /// The first failure since creation or clear(): the one that names the cause. Empty when none.
  const std::string& firstFailure() const { return failure_; }
  void clear() { failure_.clear(); }

  /// `sentence` with GDAL's own words after it, when there are any.
  std::string explain(const std::string& sentence) const;

 private:
  static void CPL_STDCALL handle(CPLErr kind, CPLErrorNum number, const char* text);

  std::string failure_;
};

} // namespace qmesh
