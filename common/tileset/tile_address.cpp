// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "tileset/tile_address.h"

#include <string_view>

#include "base/text.h"

namespace qmesh {
namespace {

constexpr std::string_view kPrefix = "QMESH:";
constexpr std::string_view kCurl = "/vsicurl/";

bool startsWith(std::string_view text, std::string_view start) {
  return text.size() >= start.size() && equalIgnoringCase(text.substr(0, start.size()), start);
}

bool isUrl(std::string_view text) {
  return startsWith(text, "http://") || startsWith(text, "https://");
}

/// A path on a server, so that "?" begins a query.
bool isRemote(std::string_view path) {
  return startsWith(path, kCurl);
}

std::string_view withoutQuery(std::string_view path) {
  return path.substr(0, path.find('?'));
}

std::string_view queryOf(std::string_view path) {
  const std::size_t mark = path.find('?');
  return mark == std::string_view::npos ? std::string_view() : path.substr(mark + 1);
}

bool namesLayerJson(std::string_view path) {
  return path.size() >= 5 && equalIgnoringCase(path.substr(path.size() - 5), ".json");
}

/// "/vsicurl/http://host" of a path on that host.
std::string hostOf(const std::string& path) {
  const std::size_t begin = path.find("://");
  const std::size_t end = begin == std::string::npos ? begin : path.find('/', begin + 3);
  return path.substr(0, end);
}

void replaceAll(std::string& text, std::string_view what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

/// The pattern against the folder of a layer.json on a server.
std::string resolveRemote(const std::string& folder, const std::string& pattern) {
  if (isUrl(pattern))
    return std::string(kCurl) + pattern;
  if (startsWith(pattern, "//"))
    return folder.substr(0, folder.find("//")) + pattern;
  if (startsWith(pattern, "/"))
    return hostOf(folder) + pattern;
  return folder + "/" + (startsWith(pattern, "./") ? pattern.substr(2) : pattern);
}

/// The pattern against a folder.
std::string resolveLocal(const std::string& folder, std::string pattern) {
  if (isUrl(pattern))
    return std::string(kCurl) + pattern;
  pattern = std::string(withoutQuery(pattern));
  if (startsWith(pattern, "/"))
    pattern = pattern.substr(std::min(pattern.find('{'), pattern.size()));
  return folder + "/" + (startsWith(pattern, "./") ? pattern.substr(2) : pattern);
}

} // namespace

std::string layerJsonPath(const std::string& path) {
  std::string clean = startsWith(path, kPrefix) ? path.substr(kPrefix.size()) : path;
  if (isUrl(clean))
    clean.insert(0, kCurl);
  const std::string_view place = isRemote(clean) ? withoutQuery(clean) : std::string_view(clean);
  if (namesLayerJson(place))
    return clean;
  const std::string rest = clean.substr(place.size());
  clean.resize(place.size());
  while (clean.size() > 1 && clean.back() == '/')
    clean.pop_back();
  return (clean.empty() ? "." : clean) + (clean == "/" ? "" : "/") + "layer.json" + rest;
}

TileAddress::TileAddress(const std::string& layerPath, const LayerJson& layer)
    : scheme_(layer.profile), slippyMap_(layer.slippyMap) {
  const bool onServer = isRemote(layerPath);
  const std::string place(onServer ? withoutQuery(layerPath) : std::string_view(layerPath));
  const std::size_t slash = place.rfind('/');
  folder_ = slash == std::string::npos ? "." : place.substr(0, slash);
  pattern_ = onServer ? resolveRemote(folder_, layer.tiles.front())
                      : resolveLocal(folder_, layer.tiles.front());
  remote_ = isRemote(pattern_);
  const std::string_view query = onServer ? queryOf(layerPath) : std::string_view();
  if (remote_ && !query.empty())
    pattern_ += (pattern_.find('?') == std::string::npos ? "?" : "&") + std::string(query);
  replaceAll(pattern_, "{version}", layer.version);
}

std::string TileAddress::of(TileId tile) const {
  const std::uint32_t turned = scheme_.tilesY(tile.z) - 1 - tile.y;
  std::string path = pattern_;
  replaceAll(path, "{z}", std::to_string(tile.z));
  replaceAll(path, "{x}", std::to_string(tile.x));
  replaceAll(path, "{y}", std::to_string(slippyMap_ ? turned : tile.y));
  replaceAll(path, "{reverseY}", std::to_string(slippyMap_ ? tile.y : turned));
  return path;
}

bool TileAddress::plainFolders() const {
  return !remote_ && pattern_ == folder_ + "/{z}/{x}/{y}.terrain";
}

} // namespace qmesh
