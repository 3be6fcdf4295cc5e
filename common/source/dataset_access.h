// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <cpl_string.h>
#include <gdal_priv.h>

#include "base/status.h"

namespace qmesh {

/// Closes what we opened; a dataset of the host's stays open.
struct DatasetCloser {
  bool ours = true;
  void operator()(GDALDataset* dataset) const;
};
using DatasetPtr = std::unique_ptr<GDALDataset, DatasetCloser>;

/// How threads get at the input. Either by name, and then each has a dataset of its own; or through
/// one open dataset of the host's, which they use one at a time, holding mutex(). Const after it is
/// made; threads share it.
class DatasetAccess {
 public:
  DatasetAccess() = default;

  /// By name: GDAL's drivers `formats` (all where empty) with these open options.
  static DatasetAccess byName(const std::string& path, const std::vector<std::string>& formats,
                              const std::vector<std::string>& openOptions);

  /// Of a dataset that the host holds open as long as this lives. Threads open it again by name
  /// where that provably gives the same pixels in band `band`: it is read-only, named as a file
  /// that is there, and opened again it has the same driver, sizes, masks and overviews; a VRT also
  /// the same XML. Everything else (memory, update mode, no name, a VRT changed since) goes through
  /// the one handle.
  static DatasetAccess ofHost(GDALDataset& host, int band);

  /// The dataset to take the description from: the host's own where there is one.
  Result<DatasetPtr> describe() const;

  /// A dataset for one thread. Code::input with GDAL's reason.
  Result<DatasetPtr> open() const;

  /// To be held while a dataset of open() is used; null where each thread has its own.
  std::mutex* mutex() const { return mutex_.get(); }

  /// Gives the calling thread the configuration options that the thread which made this had as its
  /// own (credentials, say).
  void enterThread() const;

 private:
  enum class VrtSources { shared, own }; ///< with other datasets of the thread, or not
  Result<DatasetPtr> reopen(VrtSources sources) const;

  std::string path_;
  CPLStringList formats_, openOptions_;
  CPLStringList threadOptions_;
  GDALDataset* host_ = nullptr;
  std::shared_ptr<std::mutex> mutex_;
};

/// Holds `mutex` for its scope; nothing where that is null.
std::unique_lock<std::mutex> lockOf(std::mutex* mutex);

} // namespace qmesh
