// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/option_rows.h"

#include "compare/compare_options.h"
#include "options/method_rows.h"
#include "options/row_builder.h"
#include "options/value_grammars.h"
#include "sink/output_options.h"

namespace qmesh {

namespace {

using Group = OptionGroup;
using Type = OptionType;
using Rows = std::vector<OptionRow>;

Rows argumentRows() {
  return {
      RowBuilder(Group::arguments, "input")
          .position(1)
          .value("INPUT")
          .text(&InputOptions::path, Type::file)
          .essential()
          .help("The DEM: any raster that GDAL reads, with heights in one band."),
      RowBuilder(Group::arguments, "output")
          .position(2)
          .value("OUTPUT")
          .text(&OutputOptions::path, Type::folder)
          .whenUnset("INPUT's name without extension, in the current folder")
          .essential()
          .help("The folder of the tileset: layer.json and {z}/{x}/{y}.terrain."),
  };
}

Rows inputRows() {
  return {
      RowBuilder(Group::input, "s_srs", 's')
          .value("SRS")
          .text(&InputOptions::sourceSrs, Type::srs)
          .whenUnset("the DEM's own")
          .notInDriver("-a_srs")
          .essential()
          .help("The coordinate system of the DEM. Overrides the DEM's own."),
      RowBuilder(Group::input, "band", 'b')
          .value("N")
          .integer(&InputOptions::band, 1)
          .notInDriver("-b")
          .help("The band with the heights."),
      RowBuilder(Group::input, "srcnodata", 'a')
          .value("NODATA")
          .custom<InputOptions>(Type::number, setNodata, nodataText)
          .whenUnset("the DEM's own")
          .notInDriver("-a_nodata")
          .essential()
          .help("The nodata value of the DEM. Overrides the DEM's own. NaN and infinite cells are "
                "always nodata."),
      RowBuilder(Group::input, "te")
          .value("XMIN YMIN XMAX YMAX")
          .words(4)
          .custom<InputOptions>(Type::extent, setExtent, extentText)
          .whenUnset("all of the DEM")
          .notInDriver("-projwin")
          .essential()
          .help("Use only the part of the DEM in this box. --te-srs is its coordinate system."),
      RowBuilder(Group::input, "te-srs")
          .value("SRS")
          .text(&InputOptions::extentSrs, Type::srs)
          .whenUnset("that of the DEM")
          .notInDriver("-projwin_srs")
          .help("The coordinate system of --te."),
      RowBuilder(Group::input, "cutline")
          .value("FILE")
          .text(&InputOptions::cutline, Type::file)
          .whenUnset("none")
          .notInDriver()
          .help("Use only the part of the DEM inside the polygons of this vector file."),
      RowBuilder(Group::input, "oo")
          .value("KEY=VALUE")
          .list(&InputOptions::openOptions, Type::keyValue)
          .whenUnset("none")
          .advanced()
          .notInDriver("-oo")
          .help("An open option for the GDAL driver that reads the DEM."),
      RowBuilder(Group::input, "if")
          .value("FORMAT")
          .list(&InputOptions::inputFormats, Type::text)
          .whenUnset("all")
          .advanced()
          .notInDriver("-if")
          .help("A GDAL driver that may read the DEM."),
  };
}

Rows heightRows() {
  const auto height = [](const char* name, auto field, const char* sentence) {
    return RowBuilder(Group::heights, name)
        .value("HEIGHT")
        .unit("m")
        .number(field, kLowestHeight, kHighestHeight)
        .whenUnset("none")
        .help(sentence);
  };
  const auto scale = [](const char* name, auto field, const char* sentence) {
    return RowBuilder(Group::heights, name).value("FACTOR").number(field, 0, 10000).help(sentence);
  };
  return {
      RowBuilder(Group::heights, "bathymetry")
          .flag(&HeightOptions::bathymetry)
          .help("The DEM has depths, positive down: 30 means 30 m below sea level."),
      height("clip-low", &HeightOptions::clipLow, "Raise lower heights to this height."),
      height("clip-high", &HeightOptions::clipHigh, "Lower higher heights to this height."),
      scale("scale-above", &HeightOptions::scaleAbove,
            "Multiply heights above 0, before clipping."),
      scale("scale-below", &HeightOptions::scaleBelow,
            "Multiply heights below 0, before clipping."),
      RowBuilder(Group::heights, "void-fill")
          .value("HEIGHT|interpolate")
          .unit("m")
          .custom<HeightOptions>(Type::text, setVoidFill, voidFillText)
          .essential()
          .help("The height of voids (cells and areas without data), or interpolate: from the "
                "heights around."),
  };
}

RowBuilder zoomRow(const char* name, std::optional<int> TilingOptions::*field) {
  return RowBuilder(Group::tiling, name).value("ZOOM").integer(field, 0, kMaxZoom);
}

RowBuilder tileLimitRow(const char* name, std::optional<std::int64_t> TilingOptions::*field,
                        const char* sentence) {
  return RowBuilder(Group::tiling, name)
      .value("TILE")
      .integer(field, 0, (std::int64_t{2} << kMaxZoom) - 1)
      .whenUnset("no limit")
      .advanced()
      .help(sentence);
}

Rows pyramidRows() {
  return {
      RowBuilder(Group::tiling, "profile", 'p')
          .value("PROFILE")
          .choice(&TilingOptions::profile)
          .refusal("terrain is on the globe: the raster profile of gdal2tiles and other tiling "
                   "schemes are "
                   "not supported")
          .essential()
          .help("The tiling scheme."),
      RowBuilder(Group::tiling, "zoom", 'z')
          .value("MIN-MAX|MIN-|N")
          .custom<TilingOptions>(
              Type::zooms,
              [](TilingOptions& o, const std::string& text) {
                return setZooms(o.minZoom, o.maxZoom, text);
              },
              [](const TilingOptions& o) { return zoomsText(o.minZoom, o.maxZoom); })
          .whenUnset("0 to the DEM's native zoom")
          .essential()
          .help("The zooms to make. N makes one zoom. MIN- ends at the native zoom, the first one "
                "whose node spacing is as fine as the DEM's cells. Zooms are 0 to 24."),
      zoomRow("min-zoom", &TilingOptions::minZoom)
          .whenUnset("0")
          .help("The first zoom. CesiumJS needs zoom 0, even if the tileset covers another one."),
      zoomRow("max-zoom", &TilingOptions::maxZoom)
          .whenUnset("the DEM's native zoom")
          .help("The last zoom."),
      tileLimitRow("min-x", &TilingOptions::minX, "The first tile column, at the last zoom."),
      tileLimitRow("max-x", &TilingOptions::maxX, "The last tile column, at the last zoom."),
      tileLimitRow("min-y", &TilingOptions::minY,
                   "The first tile row from the south, at the last zoom."),
      tileLimitRow("max-y", &TilingOptions::maxY,
                   "The last tile row from the south, at the last zoom."),
  };
}

Rows nodeRows() {
  return {
      RowBuilder(Group::tiling, "tilesize")
          .value("CELLS")
          .unit("cells per tile edge")
          .powersOfTwo(kSmallestTile, kLargestTile)
          .custom<TilingOptions>(Type::integer, setTileSize, tileSizeText)
          .help("The finest mesh of a tile."),
      RowBuilder(Group::tiling, "resampling", 'r')
          .value("METHOD")
          .choice(&InputOptions::resampling)
          .help("How the nodes of the last zoom get their heights from the DEM's cells."),
      RowBuilder(Group::tiling, "overview-resampling")
          .value("METHOD")
          .choice(&TilingOptions::overviewResampling)
          .help("How each zoom gets its heights from the next finer zoom."),
      RowBuilder(Group::tiling, "exclude", 'x')
          .flag(&TilingOptions::excludeVoid)
          .help("Do not write tiles without data. Otherwise they are filled, see --void-fill."),
      RowBuilder(Group::tiling, "xyz")
          .flag(&OutputOptions::xyz)
          .help(
              "Number tile rows from the north (XYZ, slippy map) instead of from the south (TMS)."),
      RowBuilder(Group::tiling, "tmscompatible", 'd')
          .noEffect("")
          .help("Accepted for compatibility with gdal2tiles. It is always on: the geodetic profile "
                "has two tiles at zoom 0."),
  };
}

Rows meshRows() {
  return {
      RowBuilder(Group::meshes, "normals")
          .flag(&OutputOptions::normals)
          .help("Write vertex normals, which CesiumJS needs for lighting."),
      RowBuilder(Group::meshes, "metadata")
          .value("N")
          .unit("zooms")
          .integer(&OutputOptions::metadata, 0, kMaxZoom)
          .advanced()
          .help("Write the metadata extension: tiles at every N-th zoom list the tiles below them "
                "for the next N zooms. Only clients that read this list need it, because "
                "layer.json lists all tiles. 0: no metadata."),
  };
}

Rows outputRows() {
  return {
      RowBuilder(Group::output, "compress")
          .value("HOW")
          .choice(&OutputOptions::compression)
          .help("The compression of the tiles."),
      RowBuilder(Group::output, "overwrite")
          .flag(&OutputOptions::overwrite)
          .notInDriver()
          .essential()
          .help("Replace the tileset in OUTPUT when the new one is complete. Other files in OUTPUT "
                "stay. Without this option, OUTPUT must be empty."),
      RowBuilder(Group::output, "webviewer", 'w')
          .value("VIEWER")
          .choice(&OutputOptions::preview)
          .notInDriver()
          .essential()
          .help("Write a preview page beside the tiles."),
      RowBuilder(Group::output, "cesium")
          .value("DIR")
          .text(&OutputOptions::cesium, Type::folder)
          .whenUnset("Cesium's download site")
          .notInDriver()
          .help("A CesiumJS build to copy beside the preview page."),
      RowBuilder(Group::output, "title", 't')
          .value("TITLE")
          .text(&OutputOptions::title, Type::text, true)
          .whenUnset("the name of INPUT")
          .help("The title of the tileset, for layer.json and the preview page."),
      RowBuilder(Group::output, "copyright", 'c')
          .value("TEXT")
          .text(&OutputOptions::copyright, Type::text, true)
          .whenUnset("none")
          .help("The attribution of the data, for layer.json and the preview page."),
      RowBuilder(Group::output, "report")
          .value("FILE")
          .text(&OutputOptions::report, Type::file)
          .whenUnset("none")
          .notInDriver()
          .help("Write a JSON report: tiles, triangles, bytes, errors and seconds."),
      RowBuilder(Group::output, "debug-meshes")
          .value("DIR")
          .text(&OutputOptions::debugMeshes, Type::folder)
          .whenUnset("none")
          .advanced()
          .notInDriver()
          .help("Also write the mesh of each tile to DIR, for 3D programs: DIR/{z}/{x}/{y}.ply, in "
                "metres around the centre of the tile."),
      RowBuilder(Group::output, "debug-format")
          .value("FORMAT")
          .choice(&OutputOptions::debugFormat)
          .advanced()
          .notInDriver()
          .help("The file format of --debug-meshes."),
      RowBuilder(Group::output, "force-kml", 'k')
          .noEffect("terrain has no KML")
          .help("Accepted for compatibility with gdal2tiles. It has no effect."),
      RowBuilder(Group::output, "no-kml", 'n')
          .noEffect("terrain has no KML")
          .help("Accepted for compatibility with gdal2tiles. It has no effect."),
      RowBuilder(Group::output, "googlekey", 'g')
          .value("KEY")
          .noEffect("the preview page needs no key", 1)
          .help("Accepted for compatibility with gdal2tiles. It has no effect."),
  };
}

Rows runningRows() {
  return {
      RowBuilder(Group::running, "num-threads", 'j')
          .alias("processes")
          .value("N|ALL_CPUS")
          .custom<RunOptions>(Type::threads, setThreads, threadsText)
          .essential()
          .help("The number of threads."),
      RowBuilder(Group::running, "memory")
          .value("SIZE")
          .custom<RunOptions>(Type::memory, setMemory, memoryText)
          .essential()
          .help("The memory limit, including the block cache of GDAL: 512MB, 2GB, 40% of the "
                "machine, or a number of bytes."),
      RowBuilder(Group::running, "block-tiles")
          .value("auto|2|4|8")
          .unit("tiles per block edge")
          .custom<RunOptions>(Type::text, setBlockTiles, blockTilesText)
          .advanced()
          .help("The tiles per block edge. A block is the unit of work of one thread. auto: from "
                "--memory and --num-threads."),
      RowBuilder(Group::running, "config-file")
          .value("FILE")
          .text(&RunOptions::configFile, Type::file)
          .commandLineOnly()
          .whenUnset("none")
          .help("Read options from a file with lines 'name = value'. Flags take 'on' or 'off'. A "
                "'#' starts a comment. The command line overrides the file."),
      RowBuilder(Group::running, "dry-run")
          .flag(&RunOptions::dryRun)
          .notInDriver()
          .essential()
          .help(
              "Print the number of tiles per zoom and estimates of size and time. Write nothing."),
      RowBuilder(Group::running, "compare")
          .flag(&CompareOptions::enabled)
          .notInDriver()
          .help("Compare all methods, once at the triangle count of --method and once at its "
                "error. Prints a table, writes comparison.csv and pictures to OUTPUT, makes no "
                "tileset. Works on the tiles from --min-x to --max-y, or on the tile of the last "
                "zoom with the most triangles."),
      RowBuilder(Group::running, "compare-tile")
          .value("Z/X/Y")
          .custom<CompareOptions>(Type::text, setCompareTile, compareTileText)
          .whenUnset("chosen by --compare")
          .advanced()
          .notInDriver()
          .help("The tile that --compare works on. Y counts from the south."),
      RowBuilder(Group::running, "quiet", 'q')
          .flag(&RunOptions::quiet)
          .notInDriver()
          .help("Print only errors."),
      RowBuilder(Group::running, "verbose", 'v')
          .flag(&RunOptions::verbose)
          .notInDriver()
          .help("Print details."),
  };
}

Rows informationRows() {
  return {
      RowBuilder(Group::information, "usage", 'h')
          .request(Request::briefHelp)
          .essential()
          .help("Print the most important options."),
      RowBuilder(Group::information, "help")
          .request(Request::help)
          .essential()
          .help("Print all options."),
      RowBuilder(Group::information, "version")
          .request(Request::version)
          .help("Print the version."),
      RowBuilder(Group::information, "options-json")
          .request(Request::optionsJson)
          .help("Print all options as JSON, for programs that show a form."),
  };
}

} // namespace

std::vector<OptionRow> optionRows(const std::vector<Choice>& methods) {
  Rows all;
  for (const Rows& rows :
       {argumentRows(), inputRows(), heightRows(), pyramidRows(), nodeRows(), methodRows(methods),
        meshRows(), outputRows(), runningRows(), informationRows()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

} // namespace qmesh
