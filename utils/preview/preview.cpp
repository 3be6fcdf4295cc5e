// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "preview.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "base/text.h"
#include "preview_texts.h"

namespace qmesh {

namespace fs = std::filesystem;

const char kCesiumFolder[] = "Cesium";

namespace {

/// The template with @NAME@ replaced. One pass: a value that contains @NAME@ stays as it is.
std::string fillIn(const std::string& text,
                   const std::vector<std::pair<std::string, std::string>>& values) {
  std::string out;
  std::size_t at = 0;
  while (at < text.size()) {
    bool replaced = false;
    for (const auto& [name, value] : values) {
      if (text.compare(at, name.size(), name) == 0) {
        out += value;
        at += name.size();
        replaced = true;
        break;
      }
    }
    if (!replaced)
      out += text[at++];
  }
  return out;
}

std::string heading(const BuildOptions& options) {
  return options.output.title.empty() ? fs::path(options.input.path).stem().string()
                                      : options.output.title;
}

/// Removes the working folder on every way out.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(fs::path path) : path_(std::move(path)) { remove(); }
  ~TemporaryFolder() { remove(); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  void remove() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  fs::path path_;
};

} // namespace

std::vector<PreviewFile> previewFiles(const BuildOptions& options) {
  if (options.output.preview == Preview::none)
    return {};
  const std::string base =
      options.output.cesium.empty() ? kCesiumSite : std::string(kCesiumFolder) + "/";
  const std::string page = fillIn(kIndexHtml, {{"@TITLE@", escapeMarkup(heading(options))},
                                               {"@CESIUM_BASE@", escapeMarkup(base)}});
  return {{"index.html", page},
          {"preview.js", kPreviewJs},
          {"look.js", kLookJs},
          {"preview.css", kPreviewCss}};
}

Result<std::string> findCesium(const std::string& folder) {
  for (const char* inside : {"", "Build/Cesium"}) {
    const fs::path candidate = fs::path(folder) / inside;
    std::error_code ignored;
    if (fs::is_regular_file(candidate / "Cesium.js", ignored) &&
        fs::is_regular_file(candidate / "Widgets" / "widgets.css", ignored) &&
        fs::is_directory(candidate / "Workers", ignored)) {
      return candidate.lexically_normal().string();
    }
  }
  return Status(Code::usage, "--cesium: there is no built CesiumJS in \"" + folder +
                                 "\"; name the folder Build/Cesium of a CesiumJS release, which "
                                 "holds Cesium.js, Workers and Widgets.");
}

Status copyCesium(const std::string& folder, const std::string& output) {
  const auto cesium = findCesium(folder);
  if (!cesium.ok())
    return cesium.status();
  const fs::path target = fs::path(output) / kCesiumFolder;
  const TemporaryFolder fresh(fs::path(output) / ".qmesh-cesium-new");
  const TemporaryFolder old(fs::path(output) / ".qmesh-cesium-old");
  std::error_code error;
  fs::copy(*cesium, fresh.path(), fs::copy_options::recursive, error);
  const bool replaces = !error && fs::exists(target, error);
  if (!error && replaces)
    fs::rename(target, old.path(), error);
  if (!error)
    fs::rename(fresh.path(), target, error);
  if (error) {
    std::error_code ignored;
    if (replaces && !fs::exists(target, ignored))
      fs::rename(old.path(), target, ignored);
    return Status(Code::output, "cannot copy CesiumJS from \"" + *cesium + "\" to \"" +
                                    target.string() + "\": " + error.message() +
                                    ". Make room or choose another output folder.");
  }
  return {};
}

} // namespace qmesh
