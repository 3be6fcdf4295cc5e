// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// What a sink stores, the reader lists and reads: for every type of output.
#include "tileset/tile_reader.h"

#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include "sink/sink_types.h"
#include "tileset/tile_address.h"
#include "vsi/vsi_files.h"

namespace qmesh {
namespace {

std::vector<std::uint8_t> bytesOf(TileId tile) {
  return std::vector<std::uint8_t>(10 + tile.x, std::uint8_t(tile.z + 7 * tile.y));
}

class TileReaderTest : public testing::TestWithParam<bool> {
 protected:
  /// Writes the tiles to `path` and opens them.
  std::shared_ptr<const TileReader> written(const std::string& path) {
    options_.path = path;
    options_.xyz = GetParam();
    options_.overwrite = true;
    auto opened = openSink(options_);
    EXPECT_TRUE(opened.ok()) << opened.status().message();
    for (const TileId tile : tiles_)
      EXPECT_TRUE(opened->sink->writeTile(tile, bytesOf(tile)).ok());
    EXPECT_TRUE(opened->sink->commit("{\"format\": \"quantized-mesh-1.0\"}").ok());
    LayerJson layer;
    layer.slippyMap = options_.xyz;
    return openTileReader(layerJsonPath(path), layer);
  }

  void expectReadBack(const TileReader& reader) const {
    for (const TileId tile : tiles_) {
      const auto read = reader.readTile(tile);
      ASSERT_TRUE(read.ok()) << read.status().message();
      ASSERT_TRUE(*read) << reader.pathOf(tile);
      EXPECT_EQ(bytesOf(tile), **read) << reader.pathOf(tile);
    }
    const auto missing = reader.readTile({3, 0, 0});
    ASSERT_TRUE(missing.ok());
    EXPECT_FALSE(*missing) << "no file, and no fault";
    const std::vector<std::vector<TileRange>> expected = {{{0, 0, 1, 0}}, {}, {{2, 1, 3, 1}}};
    EXPECT_EQ(expected, reader.listTiles());
  }

  OutputOptions options_;
  const std::vector<TileId> tiles_ = {{0, 0, 0}, {0, 1, 0}, {2, 2, 1}, {2, 3, 1}};
};

TEST_P(TileReaderTest, ReadsAFolder) {
  expectReadBack(*written("/vsimem/tile-reader/folder"));
}

// An archive of its own for each case: GDAL remembers what is in one.
TEST_P(TileReaderTest, ReadsAZipArchive) {
  expectReadBack(
      *written(std::string("/vsizip//vsimem/tile-reader/") + (GetParam() ? "n" : "s") + ".zip"));
}

TEST_P(TileReaderTest, ASingleTileHasOthersBesideIt) {
  const auto others = written("/vsimem/tile-reader/single");
  const std::string path = "/vsimem/tile-reader/alone.terrain";
  ASSERT_TRUE(writeWholeFile(path, "alone", 5).ok());
  const auto reader = openSingleTile({2, 2, 1}, path, others);
  const auto alone = reader->readTile({2, 2, 1});
  ASSERT_TRUE(alone.ok() && *alone);
  EXPECT_EQ(5u, (*alone)->size());
  EXPECT_EQ(path, reader->pathOf({2, 2, 1}));
  const auto other = reader->readTile({2, 3, 1});
  ASSERT_TRUE(other.ok() && *other);
  EXPECT_EQ(bytesOf({2, 3, 1}), **other);
  EXPECT_EQ((std::vector<std::vector<TileRange>>{{}, {}, {{2, 1, 2, 1}}}), reader->listTiles());
}

INSTANTIATE_TEST_SUITE_P(RowsFrom, TileReaderTest, testing::Bool(),
                         [](const auto& rows) { return rows.param ? "North" : "South"; });

} // namespace
} // namespace qmesh
