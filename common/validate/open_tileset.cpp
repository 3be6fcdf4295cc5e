// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/open_tileset.h"

#include "codec/gzip.h"
#include "tileset/tile_address.h"
#include "validate/tileset_checks.h"
#include "vsi/vsi_read.h"

namespace qmesh {

namespace {

constexpr std::size_t kMaxLayer = std::size_t(256) << 20; ///< bytes

bool isTilePath(const std::string& path) {
  constexpr std::string_view kEnd = ".terrain";
  const std::string name = path.substr(0, path.find('?'));
  return name.size() > kEnd.size() &&
         name.compare(name.size() - kEnd.size(), kEnd.size(), kEnd) == 0;
}

/// The text of layer.json; "" where there is none.
Result<std::string> layerText(const std::string& path) {
  Result<FileBytes> bytes = readWholeFile(path, kMaxLayer);
  if (!bytes.ok())
    return bytes.status();
  if (!*bytes)
    return std::string();
  std::vector<std::uint8_t> text = std::move(**bytes);
  if (isGzip(text.data(), text.size())) {
    auto unpacked = gunzip(text.data(), text.size(), kMaxLayer);
    if (!unpacked.ok())
      return Status(Code::input, "'" + path + "': " + unpacked.status().message());
    text = *std::move(unpacked);
  }
  return std::string(text.begin(), text.end());
}

} // namespace

Result<OpenedTileset> openTileset(const std::string& path) {
  if (isTilePath(path)) {
    Result<Tileset> tile = Tileset::openTile(path);
    if (!tile.ok())
      return tile.status();
    return OpenedTileset{*std::move(tile), {}, false, false};
  }
  const std::string layerPath = layerJsonPath(path);
  const Result<std::string> text = layerText(layerPath);
  if (!text.ok())
    return text.status();
  Findings findings;
  CheckedLayer checked = checkLayer(*text, findings);
  Result<Tileset> set = Tileset::of(layerPath, std::move(checked.layer));
  if (!set.ok())
    return set.status();
  const bool unreadable = !findings.empty() && findings[0].code <= 102;
  if (unreadable && set->available().maxZoom() < 0)
    return Status(Code::input, findings[0].code == 101
                                   ? "there is no '" + layerPath + "', nor tiles beside it"
                                   : "'" + layerPath + "' cannot be read: " + findings[0].what);
  return OpenedTileset{*std::move(set), std::move(findings), checked.available, !unreadable};
}

} // namespace qmesh
