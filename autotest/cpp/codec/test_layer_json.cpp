// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "codec/layer_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace qmesh {
namespace {

using Strings = std::vector<std::string>;

LayerJson smallLayer() {
  LayerJson layer;
  layer.name = "Mont \"Blanc\"";
  layer.version = "1.0.0";
  layer.attribution = "caf\xc3\xa9";
  layer.bounds = {-0.1, -90, 7.25, 1e-7};
  layer.maxZoom = 1;
  layer.available = {{{0, 0, 1, 0}}, {{0, 0, 1, 1}, {3, 1, 3, 1}}};
  layer.extensions = {"octvertexnormals", "metadata"};
  layer.metadataAvailability = 5;
  layer.generator = "qmesh 0.1.0";
  layer.method = "greedy";
  layer.cellsPerTile = 256;
  layer.extent = {170, -90, 190.5, 1e-7};
  layer.levels = {{0, 19266.8355, 0.1}, {1, 0.30000000000000004, 0}};
  return layer;
}

const char* const kSmallText = R"({
  "tilejson": "2.1.0",
  "name": "Mont \"Blanc\"",
  "description": "",
  "version": "1.0.0",
  "format": "quantized-mesh-1.0",
  "attribution": "café",
  "scheme": "tms",
  "projection": "EPSG:4326",
  "bounds": [-0.1, -90, 7.25, 1e-07],
  "minzoom": 0,
  "maxzoom": 1,
  "tiles": ["{z}/{x}/{y}.terrain?v={version}"],
  "extensions": ["octvertexnormals", "metadata"],
  "metadataAvailability": 5,
  "available": [
    [
      {"startX":0,"startY":0,"endX":1,"endY":0}
    ],
    [
      {"startX":0,"startY":0,"endX":1,"endY":1},
      {"startX":3,"startY":1,"endX":3,"endY":1}
    ]
  ],
  "qmesh": {
    "generator": "qmesh 0.1.0",
    "method": "greedy",
    "cellsPerTile": 256,
    "extent": [170, -90, 190.5, 1e-07],
    "levels": [
      {"zoom": 0, "maxError": 19266.8355, "errorReached": 0.1},
      {"zoom": 1, "maxError": 0.30000000000000004, "errorReached": 0}
    ]
  }
}
)";

void expectSame(const LayerJson& a, const LayerJson& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.version, b.version);
  EXPECT_EQ(a.attribution, b.attribution);
  EXPECT_EQ(a.format, b.format);
  EXPECT_EQ(a.profile, b.profile);
  EXPECT_EQ(a.slippyMap, b.slippyMap);
  EXPECT_EQ(a.tiles, b.tiles);
  EXPECT_EQ(a.bounds.west, b.bounds.west);
  EXPECT_EQ(a.bounds.south, b.bounds.south);
  EXPECT_EQ(a.bounds.east, b.bounds.east);
  EXPECT_EQ(a.bounds.north, b.bounds.north);
  EXPECT_EQ(a.minZoom, b.minZoom);
  EXPECT_EQ(a.maxZoom, b.maxZoom);
  EXPECT_EQ(a.available, b.available);
  EXPECT_EQ(a.extensions, b.extensions);
  EXPECT_EQ(a.metadataAvailability, b.metadataAvailability);
  EXPECT_EQ(a.parentUrl, b.parentUrl);
  EXPECT_EQ(a.generator, b.generator);
  EXPECT_EQ(a.method, b.method);
  EXPECT_EQ(a.cellsPerTile, b.cellsPerTile);
  EXPECT_EQ(a.extent.west, b.extent.west);
  EXPECT_EQ(a.extent.east, b.extent.east);
  ASSERT_EQ(a.levels.size(), b.levels.size());
  for (std::size_t i = 0; i < a.levels.size(); ++i) {
    EXPECT_EQ(a.levels[i].zoom, b.levels[i].zoom);
    EXPECT_EQ(a.levels[i].maxError, b.levels[i].maxError);
    EXPECT_EQ(a.levels[i].errorReached, b.levels[i].errorReached);
  }
}

TEST(LayerJson, WritesTheGoldenText) {
  EXPECT_EQ(writeLayerJson(smallLayer()), kSmallText);
}

TEST(LayerJson, ReadsTheGoldenText) {
  const auto layer = readLayerJson(kSmallText);
  ASSERT_TRUE(layer.ok()) << layer.status().message();
  expectSame(*layer, smallLayer());
}

LayerJson randomLayer(std::mt19937& random) {
  LayerJson layer;
  const auto real = [&] { return std::ldexp(double(random()), int(random() % 40) - 50); };
  const auto text = [&] {
    std::string s;
    for (std::uint32_t k = std::uint32_t(random() % 12); k > 0; --k)
      s += char(1 + random() % 127); // with quotes, backslashes and control characters
    return s;
  };
  layer.name = text();
  layer.description = text();
  layer.version = text();
  layer.attribution = text();
  layer.parentUrl = text();
  layer.profile = random() % 2 ? Profile::mercator : Profile::geodetic;
  layer.slippyMap = random() % 2;
  layer.tiles = Strings(1 + random() % 3, text());
  layer.bounds = {-real(), -real(), real(), real()};
  layer.available.resize(random() % 8);
  const Scheme scheme(layer.profile);
  for (std::size_t z = 0; z < layer.available.size(); ++z)
    for (std::uint32_t k = std::uint32_t(random() % 5); k > 0; --k) {
      const auto below = [&](std::uint32_t n) { return std::uint32_t(random() % n); };
      const std::uint32_t x = below(scheme.tilesX(int(z))), y = below(scheme.tilesY(int(z)));
      layer.available[z].push_back({below(x + 1), below(y + 1), x, y});
    }
  layer.minZoom = int(random() % 5);
  layer.maxZoom = int(random() % 25);
  layer.extensions = Strings(random() % 3, "watermask");
  layer.metadataAvailability = int(random() % 3);
  if (random() % 2) {
    layer.method = "greedy";
    layer.generator = text();
    layer.cellsPerTile = 64;
    layer.levels = {{int(random() % 25), real(), real()}};
  }
  return layer;
}

TEST(LayerJson, ReadingGivesWhatWasWritten) {
  std::mt19937 random(71);
  for (int k = 0; k < 500; ++k) {
    const LayerJson layer = randomLayer(random);
    const auto back = readLayerJson(writeLayerJson(layer));
    ASSERT_TRUE(back.ok()) << back.status().message();
    expectSame(*back, layer);
  }
}

TEST(LayerJson, NeverWritesNaN) {
  LayerJson layer = smallLayer();
  layer.levels[0].errorReached = std::nan("");
  layer.bounds.west = -INFINITY;
  const std::string text = writeLayerJson(layer);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  const auto back = readLayerJson(text);
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->bounds.west, -180);
  EXPECT_EQ(back->levels[0].errorReached, 0);
}

/// The least text that is one, with more members.
std::string minimal(const std::string& members) {
  return R"({"format":"quantized-mesh-1.0","tiles":["{z}/{x}/{y}"])" + members + "}";
}

TEST(LayerJson, AbsentKeysTakeTheDefaultsOfClients) {
  const auto layer = readLayerJson(minimal(""));
  ASSERT_TRUE(layer.ok()) << layer.status().message();
  EXPECT_EQ(layer->profile, Profile::geodetic);
  EXPECT_FALSE(layer->slippyMap);
  EXPECT_EQ(layer->bounds.west, -180);
  EXPECT_EQ(layer->maxZoom, 0);
  EXPECT_TRUE(layer->available.empty());
  EXPECT_TRUE(layer->method.empty());
}

TEST(LayerJson, ReadsWhatOtherProducersWrite) {
  const auto layer =
      readLayerJson("\xef\xbb\xbf" +
                    minimal(R"(,"version":1.1,"extensions":["vertexnormals",3],"scheme":"slippyMap",
      "projection":"EPSG:3857","maxzoom":30,"minzoom":"a","bounds":"world","schema":"tms",
      "available":[[{"startX":0,"startY":0,"endX":0,"endY":0,"more":1}],[]],"deep":[[[[1]]]],
      "qmesh":7,"metadataAvailability":-3,"name":null)"));
  ASSERT_TRUE(layer.ok()) << layer.status().message();
  EXPECT_EQ(layer->version, "1.1");
  EXPECT_EQ(layer->extensions, Strings{"vertexnormals"});
  EXPECT_TRUE(layer->slippyMap);
  EXPECT_EQ(layer->profile, Profile::mercator);
  EXPECT_EQ(layer->maxZoom, 1);
  EXPECT_EQ(layer->minZoom, 0);
  EXPECT_EQ(layer->bounds.north, 90);
  EXPECT_EQ(layer->available.size(), 2u);
  EXPECT_EQ(layer->metadataAvailability, 0);
}

void expectFault(const std::string& text, const std::string& words) {
  const auto layer = readLayerJson(text);
  ASSERT_FALSE(layer.ok()) << text.substr(0, 200);
  EXPECT_EQ(layer.status().code(), Code::input);
  EXPECT_NE(layer.status().message().find(words), std::string::npos) << layer.status().message();
}

std::string available(const std::string& range) {
  return minimal(",\"available\":[[" + range + "]]");
}

TEST(LayerJson, SaysWhatIsWrong) {
  expectFault("", "not JSON");
  expectFault("{", "not JSON");
  expectFault(minimal("") + "x", "not JSON");
  expectFault(minimal(",\"a\":NaN"), "not JSON");
  expectFault(minimal(",\"a\":1e999"), "not JSON");
  expectFault("[]", "not a JSON object");
  expectFault(R"({"tiles":["a"]})", "which format");
  expectFault(R"({"format":"heightmap-1.0","tiles":["a"]})", "heightmap-1.0");
  expectFault(R"({"format":"quantized-mesh-1.0"})", "\"tiles\"");
  expectFault(R"({"format":"quantized-mesh-1.0","tiles":[]})", "\"tiles\"");
  expectFault(minimal(R"(,"scheme":"xyz")"), "xyz");
  expectFault(minimal(R"(,"projection":"EPSG:25832")"), "EPSG:25832");
  expectFault(minimal(R"(,"available":3)"), "not a list");
  expectFault(minimal(R"(,"available":[3])"), "zoom 0");
  expectFault(minimal(R"(,"available":[[],[],[],[],[],[],[],[],[],[],[],[],[],)"
                      R"([],[],[],[],[],[],[],[],[],[],[],[],[]])"),
              "deeper than zoom 24");
}

TEST(LayerJson, RefusesAbsurdRanges) {
  EXPECT_TRUE(readLayerJson(available(R"({"startX":1,"startY":0,"endX":1,"endY":0})")).ok());
  for (const char* range :
       {R"({"startX":0,"startY":0,"endX":2,"endY":0})",
        R"({"startX":0,"startY":0,"endX":0,"endY":1})",
        R"({"startX":1,"startY":0,"endX":0,"endY":0})",
        R"({"startX":-1,"startY":0,"endX":0,"endY":0})",
        R"({"startX":0.5,"startY":0,"endX":1,"endY":0})", R"({"startX":0,"startY":0,"endX":1})",
        R"({"startX":"0","startY":0,"endX":1,"endY":0})",
        R"({"startX":0,"startY":0,"endX":18446744073709551616,"endY":0})", "[0,0,1,0]", "null"})
    expectFault(available(range), "zoom 0");
}

TEST(LayerJson, KeepsTheLimitOfDepth) {
  const auto nested = [](std::size_t depth) { // the object itself is the first level
    return minimal(",\"a\":" + std::string(depth - 1, '[') + std::string(depth - 1, ']'));
  };
  EXPECT_TRUE(readLayerJson(nested(64)).ok());
  expectFault(nested(65), "nested deeper");
  expectFault(nested(1000000), "nested deeper");
  expectFault(std::string(1000000, '['), "nested deeper");
}

TEST(LayerJson, RefusesEveryShorterText) {
  const std::string whole = kSmallText;
  for (std::size_t size = 0; size + 1 < whole.size(); ++size)
    EXPECT_FALSE(readLayerJson(whole.substr(0, size)).ok()) << size;
}

TEST(LayerJson, SurvivesChangedBytes) {
  const std::string whole = kSmallText;
  std::mt19937 random(72);
  for (int k = 0; k < 20000; ++k) {
    std::string text = whole;
    for (int i = 0; i < 2; ++i)
      text[random() % text.size()] = char(random() % 256);
    const auto layer = readLayerJson(text);
    if (layer.ok()) {
      EXPECT_TRUE(readLayerJson(writeLayerJson(*layer)).ok()) << text;
    }
  }
}

} // namespace
} // namespace qmesh
