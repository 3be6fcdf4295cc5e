// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "sink/zip_sink.h"

#include <algorithm>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>

#include "base/text.h"
#include "codec/gzip.h"
#include "sink/tileset_files.h"
#include "vsi/folder_lock.h"
#include "vsi/quiet_errors.h"
#include "vsi/vsi_files.h"
#include "vsi/vsi_read.h"

namespace qmesh {
namespace {

constexpr const char* kPrefix = "/vsizip/";

/// Larger files are no part of a set.
constexpr std::size_t kLargestFile = std::size_t(1) << 31;

/// An archive and the folder in it, "" for its top.
struct ZipName {
  std::string archive;
  std::string folder;

  std::string entry(const std::string& name) const {
    return folder.empty() ? name : folder + "/" + name;
  }
};

std::string withoutSlashes(std::string text) {
  while (!text.empty() && text.back() == '/')
    text.pop_back();
  text.erase(0, text.find_first_not_of('/'));
  return text;
}

Result<ZipName> parseZipName(const std::string& path) {
  const std::string rest = path.substr(std::string(kPrefix).size());
  if (!rest.empty() && rest[0] == '{') {
    const std::size_t end = rest.find('}');
    if (end != std::string::npos && end > 1)
      return ZipName{rest.substr(1, end - 1), withoutSlashes(rest.substr(end + 1))};
  }
  constexpr std::size_t kEnding = 4; // ".zip"
  for (std::size_t at = 1; at + kEnding <= rest.size(); ++at) {
    const std::size_t end = at + kEnding;
    if (equalIgnoringCase(rest.substr(at, kEnding), ".zip") &&
        (end == rest.size() || rest[end] == '/'))
      return ZipName{rest.substr(0, end), withoutSlashes(rest.substr(end))};
  }
  return Status(Code::output, "'" + path +
                                  "' names no archive; write /vsizip/NAME.zip, or "
                                  "/vsizip/{NAME}/FOLDER for another ending");
}

/// Whether every file of an archive is one a set in its folder has.
bool holdsOneSet(const ZipName& name) {
  const std::string top = std::string(kPrefix) + "{" + name.archive + "}";
  const CPLStringList entries(VSIReadDirRecursive(top.c_str()));
  const std::string prefix = name.folder.empty() ? "" : name.folder + "/";
  for (int k = 0; k < entries.Count(); ++k) {
    const std::string entry = entries[k];
    if (entry.back() == '/' || entry == name.folder)
      continue;
    if (entry.compare(0, prefix.size(), prefix) != 0 || !isTilesetFile(entry.substr(prefix.size())))
      return false;
  }
  return holdsTileset(name.folder.empty() ? top : top + "/" + name.folder);
}

/// Writes one archive, entry by entry.
class ZipWriter {
 public:
  explicit ZipWriter(const std::string& path) : path_(path) {
    handle_ = CPLCreateZip(path.c_str(), nullptr);
  }
  ~ZipWriter() {
    if (handle_)
      CPLCloseZip(handle_);
  }
  ZipWriter(const ZipWriter&) = delete;
  ZipWriter& operator=(const ZipWriter&) = delete;

  Status add(const std::string& entry, const std::vector<std::uint8_t>& bytes) {
    CPLStringList options;
    options.SetNameValue("COMPRESSED", isGzip(bytes.data(), bytes.size()) ? "NO" : "YES");
    options.SetNameValue("TIMESTAMP", kTime);
    const bool written = handle_ &&
                         CPLCreateFileInZip(handle_, entry.c_str(), options.List()) == CE_None &&
                         CPLWriteFileInZip(handle_, bytes.data(), int(bytes.size())) == CE_None;
    const bool closed = written && CPLCloseFileInZip(handle_) == CE_None;
    return closed ? Status() : fault();
  }

  Status finish() {
    const bool closed = handle_ && CPLCloseZip(handle_) == CE_None;
    handle_ = nullptr;
    return closed ? Status() : fault();
  }

 private:
  /// The first second of a zip archive's calendar: newer GDAL would write the time of day.
  static constexpr const char* kTime = "315532800";

  Status fault() const {
    return {Code::output, "the archive '" + path_ + "' cannot be written; is the disk full?"};
  }

  std::string path_;
  void* handle_;
};

class ZipSink : public TileSink {
 public:
  ZipSink(ZipName name, bool xyz)
      : name_(std::move(name)), work_(name_.archive + kHiddenFolderName), xyz_(xyz) {}
  ~ZipSink() override { ZipSink::abandon(); }

  Status open(bool overwrite);

  Status writeTile(TileId tile, const std::vector<std::uint8_t>& bytes) override {
    return writeWholeFile(newFolder() + "/" + tileFileName(tile, xyz_), bytes.data(), bytes.size());
  }
  Status writeFile(const std::string& name, const std::string& text) override {
    return writeWholeFile(newFolder() + "/" + name, text.data(), text.size());
  }
  Status commit(const std::string& layerJson) override;
  void abandon() override;

  const std::string& workFolder() const { return work_; }

 private:
  std::string newFolder() const { return work_ + "/new"; }
  Status pack(const std::string& archive);

  ZipName name_;
  std::string work_; ///< folder beside the archive
  bool xyz_;
  bool open_ = false;
  FolderLock lock_;
  std::vector<std::string> made_; ///< folders that were not there, the outermost first
};

Status ZipSink::open(bool overwrite) {
  if (pathExists(name_.archive)) {
    if (!holdsOneSet(name_))
      return {Code::output, "the file '" + name_.archive +
                                "' exists and is not an archive of one set in that place; name "
                                "another one"};
    if (!overwrite)
      return {Code::output,
              "the archive '" + name_.archive + "' exists; --overwrite replaces the set in it"};
  }
  QMESH_RETURN_IF_ERROR(makeFolders(work_, &made_));
  QMESH_RETURN_IF_ERROR(lock_.acquire(work_ + "/" + kLockFileName));
  open_ = true;
  for (const std::string& name : listFolder(work_)) // of a run that was killed
    if (name != kLockFileName)
      removeTree(work_ + "/" + name);
  return {};
}

Status ZipSink::pack(const std::string& archive) {
  const CPLStringList names(VSIReadDirRecursive(newFolder().c_str()));
  std::vector<std::string> files;
  for (int k = 0; k < names.Count(); ++k)
    if (const std::string name = names[k];
        name.back() != '/' && name != kLayerJsonName && !isFolder(newFolder() + "/" + name))
      files.push_back(name);
  std::sort(files.begin(), files.end());
  files.emplace_back(kLayerJsonName);
  ZipWriter writer(archive);
  for (const std::string& file : files) {
    const Result<FileBytes> bytes = readWholeFile(newFolder() + "/" + file, kLargestFile);
    if (!bytes.ok())
      return bytes.status();
    if (!*bytes)
      return {Code::output, "'" + newFolder() + "/" + file + "' is gone"};
    QMESH_RETURN_IF_ERROR(writer.add(name_.entry(file), **bytes));
  }
  return writer.finish();
}

Status ZipSink::commit(const std::string& layerJson) {
  QuietErrors errors;
  QMESH_RETURN_IF_ERROR(writeFile(kLayerJsonName, layerJson));
  const std::string packed = work_ + "/set.zip";
  QMESH_RETURN_IF_ERROR(pack(packed));
  QMESH_RETURN_IF_ERROR(renamePath(packed, name_.archive));
  abandon();
  return {};
}

void ZipSink::abandon() {
  if (!open_)
    return;
  open_ = false;
  QuietErrors errors;
  for (const std::string& name : listFolder(work_))
    if (name != kLockFileName)
      removeTree(work_ + "/" + name);
  lock_.release();
  VSIRmdir(work_.c_str());
  for (; !made_.empty(); made_.pop_back()) // those that the archive does not lie in
    VSIRmdir(made_.back().c_str());
}

} // namespace

bool isZipPath(const std::string& path) {
  return path.rfind(kPrefix, 0) == 0;
}

Result<OpenedSink> openZipSink(const OutputOptions& options) {
  Result<ZipName> name = parseZipName(options.path);
  if (!name.ok())
    return name.status();
  auto sink = std::make_unique<ZipSink>(*std::move(name), options.xyz);
  QuietErrors errors;
  QMESH_RETURN_IF_ERROR(sink->open(options.overwrite));
  std::string workFolder = sink->workFolder();
  return OpenedSink{std::move(sink), std::move(workFolder)};
}

} // namespace qmesh
