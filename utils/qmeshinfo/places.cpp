// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "places.h"

#include <iostream>

#include "base/text.h"
#include "qmeshinfo/info_options.h"
#include "tileset/surface_cache.h"

namespace qmesh {

namespace {

std::vector<std::string> withStandardInput(const std::vector<std::string>& texts) {
  std::vector<std::string> all;
  for (const std::string& text : texts) {
    if (text != "-") {
      all.push_back(text);
      continue;
    }
    std::string line;
    while (std::getline(std::cin, line))
      if (!trimmed(line).empty())
        all.push_back(line);
  }
  return all;
}

Status sample(SurfaceCache& tiles, const Scheme& scheme, int lastZoom, Sample& place) {
  for (int zoom = lastZoom; zoom >= 0; --zoom) {
    const auto position = tileAt(scheme, zoom, place.lon, place.lat);
    if (!position)
      return {};
    const auto height = tiles.heightAt(*position);
    if (!height.ok())
      return height.status();
    if (!*height)
      continue;
    place.height = **height;
    place.tile = position->tile;
    return {};
  }
  return {};
}

} // namespace

Result<std::vector<Sample>> samplePlaces(const Tileset& set, int lastZoom,
                                         const std::vector<std::string>& texts) {
  SurfaceCache tiles(set);
  std::vector<Sample> samples;
  for (const std::string& text : withStandardInput(texts)) {
    const auto place = parseLonLat(text);
    if (!place.ok())
      return Status(Code::usage, "--sample " + place.status().message());
    Sample found;
    found.lon = (*place)[0];
    found.lat = (*place)[1];
    QMESH_RETURN_IF_ERROR(sample(tiles, set.scheme(), lastZoom, found));
    samples.push_back(found);
  }
  return samples;
}

} // namespace qmesh
