// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "sink/directory_sink.h"

#include <mutex>

#include <cpl_vsi.h>

#include "sink/tileset_files.h"
#include "sink/tileset_swap.h"
#include "vsi/folder_lock.h"
#include "vsi/quiet_errors.h"
#include "vsi/vsi_files.h"

namespace qmesh {
namespace {

/// OUTPUT as GDAL wants it: no slash at the end, and "./" before a relative path.
std::string cleanPath(std::string path) {
  while (path.size() > 1 && path.back() == '/')
    path.pop_back();
  const bool absolute = !path.empty() && path[0] == '/';
  return absolute || path == "." || path.rfind("./", 0) == 0 ? path : "./" + path;
}

/// A path as the user wrote it.
std::string shown(const std::string& path) {
  return path.rfind("./", 0) == 0 ? path.substr(2) : path;
}

class DirectorySink : public TileSink {
 public:
  DirectorySink(std::string output, bool xyz)
      : output_(std::move(output)), hidden_(output_ + "/" + kHiddenFolderName),
        swap_(output_, hidden_), xyz_(xyz) {}

  ~DirectorySink() override { DirectorySink::abandon(); }

  /// Everything that can be refused before the work.
  Status open(bool overwrite);

  Status writeTile(TileId tile, const std::vector<std::uint8_t>& bytes) override;
  Status writeFile(const std::string& name, const std::string& text) override;
  Status commit(const std::string& layerJson) override;
  void abandon() override;

  const std::string& workFolder() const { return hidden_; }

 private:
  Status takeFolder();
  Status clearLeftover();
  void close();

  std::string output_, hidden_;
  TilesetSwap swap_;
  bool xyz_;
  bool open_ = false;
  bool keepHidden_ = false;       ///< it holds what could not be put back
  std::vector<std::string> made_; ///< folders that were not there, the outermost first
  FolderLock lock_;
  std::mutex mutex_; ///< guards what follows
  std::vector<std::string> files_;
};

Status DirectorySink::open(bool overwrite) {
  if (pathExists(output_) && !isFolder(output_))
    return {Code::output, "'" + shown(output_) + "' is a file; the output must be a folder"};
  QMESH_RETURN_IF_ERROR(makeFolders(output_, &made_));
  Status status = takeFolder();
  if (status.ok() && !overwrite)
    for (const std::string& name : listFolder(output_))
      if (status.ok() && name != kHiddenFolderName)
        status = {Code::output, "the output folder '" + shown(output_) +
                                    "' is not empty; --overwrite replaces the set in it"};
  if (!status.ok() && !open_) // nobody else's folder is touched
    for (; !made_.empty(); made_.pop_back())
      VSIRmdir(made_.back().c_str());
  return status;
}

/// Makes the hidden folder ours and empty.
Status DirectorySink::takeFolder() {
  const bool isOurs = !pathExists(hidden_) || listFolder(hidden_).empty() ||
                      pathExists(hidden_ + "/" + kLockFileName);
  if (!isOurs)
    return {Code::output, "'" + hidden_ + "' was not made by this program; move it elsewhere"};
  QMESH_RETURN_IF_ERROR(makeFolders(hidden_));
  Status locked = lock_.acquire(hidden_ + "/" + kLockFileName);
  if (!locked.ok()) {
    VSIRmdir(hidden_.c_str()); // fails, as it should, where another run works in it
    return locked;
  }
  open_ = true;
  return clearLeftover();
}

Status DirectorySink::clearLeftover() {
  const Status undone = swap_.undo();
  keepHidden_ = !undone.ok();
  if (keepHidden_)
    return {Code::output, "a run that was stopped left parts of the set in '" + hidden_ +
                              "/old', and they cannot be put back: " + undone.message()};
  for (const std::string& name : listFolder(hidden_))
    if (name != kLockFileName)
      removeTree(hidden_ + "/" + name);
  return {};
}

Status DirectorySink::writeTile(TileId tile, const std::vector<std::uint8_t>& bytes) {
  return writeWholeFile(swap_.newFolder() + "/" + tileFileName(tile, xyz_), bytes.data(),
                        bytes.size());
}

Status DirectorySink::writeFile(const std::string& name, const std::string& text) {
  {
    const std::lock_guard<std::mutex> guard(mutex_);
    files_.push_back(name);
  }
  return writeWholeFile(swap_.newFolder() + "/" + name, text.data(), text.size());
}

Status DirectorySink::commit(const std::string& layerJson) {
  QMESH_RETURN_IF_ERROR(
      writeWholeFile(swap_.newFolder() + "/layer.json", layerJson.data(), layerJson.size()));
  Status status = swap_.run(files_);
  keepHidden_ = !status.ok() && pathExists(hidden_ + "/journal");
  if (status.ok()) {
    made_.clear();
    close();
  }
  return status;
}

void DirectorySink::abandon() {
  if (open_)
    close();
}

/// Removes the hidden folder, and the output folder if it is ours and empty.
void DirectorySink::close() {
  open_ = false;
  QuietErrors errors;
  if (!keepHidden_)
    for (const std::string& name : listFolder(hidden_))
      if (name != kLockFileName)
        removeTree(hidden_ + "/" + name);
  if (keepHidden_)
    return; // the journal stays behind, and says whose folder it is
  lock_.release();
  VSIRmdir(hidden_.c_str());
  for (; !made_.empty(); made_.pop_back())
    VSIRmdir(made_.back().c_str());
}

} // namespace

Result<OpenedSink> openDirectorySink(const OutputOptions& options) {
  auto sink = std::make_unique<DirectorySink>(cleanPath(options.path), options.xyz);
  QuietErrors errors;
  QMESH_RETURN_IF_ERROR(sink->open(options.overwrite));
  std::string workFolder = sink->workFolder();
  return OpenedSink{std::move(sink), std::move(workFolder)};
}

} // namespace qmesh
