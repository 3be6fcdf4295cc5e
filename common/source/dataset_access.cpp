// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "source/dataset_access.h"

#include <optional>

#include <cpl_conv.h>
#include <cpl_vsi.h>

#include "vsi/quiet_errors.h"

namespace qmesh {
namespace {

/// For as long as it lives, VRT files opened by this thread get sources of their own: GDAL would
/// share them between all datasets that this thread opens, and those go to different threads.
class UnsharedSources {
 public:
  UnsharedSources() {
    const char* now = CPLGetThreadLocalConfigOption(kKey, nullptr);
    had_ = now != nullptr;
    before_ = had_ ? now : "";
    CPLSetThreadLocalConfigOption(kKey, "NO");
  }
  ~UnsharedSources() { CPLSetThreadLocalConfigOption(kKey, had_ ? before_.c_str() : nullptr); }
  UnsharedSources(const UnsharedSources&) = delete;
  UnsharedSources& operator=(const UnsharedSources&) = delete;

 private:
  static constexpr const char* kKey = "VRT_SHARED_SOURCE";
  bool had_ = false;
  std::string before_;
};

CPLStringList listOf(const std::vector<std::string>& words) {
  CPLStringList list;
  for (const std::string& word : words)
    list.AddString(word.c_str());
  return list;
}

bool fileExists(const std::string& path) {
  VSIStatBufL info;
  return VSIStatExL(path.c_str(), &info, VSI_STAT_EXISTS_FLAG) == 0;
}

std::string driverName(GDALDataset& dataset) {
  GDALDriver* driver = dataset.GetDriver();
  return driver ? driver->GetDescription() : "";
}

/// A VRT's whole state as text; empty for other formats.
std::string vrtXml(GDALDataset& dataset) {
  CSLConstList xml = dataset.GetMetadata("xml:VRT");
  return xml && xml[0] ? xml[0] : "";
}

/// Whether a mask beside the nodata value makes voids; that value itself is taken from the host.
int maskKind(GDALRasterBand& band) {
  const int flags = band.GetMaskFlags();
  const bool none = (flags & GMF_ALL_VALID) != 0;
  const bool nodata = (flags & GMF_NODATA) != 0 && (flags & GMF_PER_DATASET) == 0;
  return none || nodata ? 0 : flags;
}

bool sameBand(GDALRasterBand& a, GDALRasterBand& b) {
  if (a.GetRasterDataType() != b.GetRasterDataType() || maskKind(a) != maskKind(b) ||
      a.GetOverviewCount() != b.GetOverviewCount())
    return false;
  for (int k = 0; k < a.GetOverviewCount(); ++k) {
    GDALRasterBand* ofA = a.GetOverview(k);
    GDALRasterBand* ofB = b.GetOverview(k);
    if (!ofA || !ofB || ofA->GetXSize() != ofB->GetXSize() || ofA->GetYSize() != ofB->GetYSize())
      return false;
  }
  return true;
}

bool sameRaster(GDALDataset& a, GDALDataset& b, int band) {
  return driverName(a) == driverName(b) && a.GetRasterCount() == b.GetRasterCount() &&
         a.GetRasterXSize() == b.GetRasterXSize() && a.GetRasterYSize() == b.GetRasterYSize() &&
         band >= 1 && band <= a.GetRasterCount() &&
         sameBand(*a.GetRasterBand(band), *b.GetRasterBand(band)) && vrtXml(a) == vrtXml(b);
}

} // namespace

void DatasetCloser::operator()(GDALDataset* dataset) const {
  if (!ours)
    return;
  QuietErrors errors;
  GDALClose(dataset);
}

DatasetAccess DatasetAccess::byName(const std::string& path,
                                    const std::vector<std::string>& formats,
                                    const std::vector<std::string>& openOptions) {
  DatasetAccess access;
  access.path_ = path;
  access.formats_ = listOf(formats);
  access.openOptions_ = listOf(openOptions);
  access.threadOptions_.Assign(CPLGetThreadLocalConfigOptions(), TRUE);
  return access;
}

DatasetAccess DatasetAccess::ofHost(GDALDataset& host, int band) {
  DatasetAccess access = byName(host.GetDescription(), {driverName(host)}, {});
  access.openOptions_ = CPLStringList(CSLDuplicate(host.GetOpenOptions()));
  access.host_ = &host;
  QuietErrors errors;
  const bool named = host.GetAccess() == GA_ReadOnly && !driverName(host).empty() &&
                     !access.path_.empty() && fileExists(access.path_);
  if (named) {
    // As the host opened it: a VRT's XML says whether its sources are shared.
    const Result<DatasetPtr> again = access.reopen(VrtSources::shared);
    if (again.ok() && sameRaster(host, **again, band))
      return access;
  }
  access.mutex_ = std::make_shared<std::mutex>();
  return access;
}

std::unique_lock<std::mutex> lockOf(std::mutex* mutex) {
  return mutex ? std::unique_lock<std::mutex>(*mutex) : std::unique_lock<std::mutex>();
}

Result<DatasetPtr> DatasetAccess::describe() const {
  return host_ ? DatasetPtr(host_, {false}) : reopen(VrtSources::own);
}

Result<DatasetPtr> DatasetAccess::open() const {
  return mutex_ ? DatasetPtr(host_, {false}) : reopen(VrtSources::own);
}

void DatasetAccess::enterThread() const {
  CPLSetThreadLocalConfigOptions(threadOptions_.List());
}

Result<DatasetPtr> DatasetAccess::reopen(VrtSources sources) const {
  QuietErrors errors;
  std::optional<UnsharedSources> unshared;
  if (sources == VrtSources::own)
    unshared.emplace();
  DatasetPtr dataset(GDALDataset::Open(path_.c_str(),
                                       GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                       formats_.empty() ? nullptr : formats_.List(),
                                       openOptions_.empty() ? nullptr : openOptions_.List()));
  if (dataset)
    return dataset;
  return Status(Code::input,
                fileExists(path_)
                    ? errors.explain("'" + path_ + "' is not a raster GDAL can read")
                    : "'" + path_ + "' does not exist or cannot be opened" + errors.explain(""));
}

} // namespace qmesh
