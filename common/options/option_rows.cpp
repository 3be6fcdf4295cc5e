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
          .help("The DEM: any raster GDAL reads, heights in one band."),
      RowBuilder(Group::arguments, "output")
          .position(2)
          .value("OUTPUT")
          .text(&OutputOptions::path, Type::folder)
          .whenUnset("INPUT's name without extension, in the current folder")
          .help("The folder that becomes the terrain: layer.json and {z}/{x}/{y}.terrain."),
  };
}

Rows inputRows() {
  return {
      RowBuilder(Group::input, "s_srs", 's')
          .value("SRS")
          .text(&InputOptions::sourceSrs, Type::srs)
          .whenUnset("the DEM's own")
          .notInDriver("-a_srs")
          .help("The coordinate system of the DEM, where it has none or a wrong one."),
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
          .help("The value of cells without a height. NaN and infinite cells never have one."),
      RowBuilder(Group::input, "te")
          .value("XMIN YMIN XMAX YMAX")
          .words(4)
          .custom<InputOptions>(Type::extent, setExtent, extentText)
          .whenUnset("all of the DEM")
          .notInDriver("-projwin")
          .help("Use the DEM within this box only, given in --te-srs."),
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
          .help("Use the DEM within the polygons of this vector file only."),
      RowBuilder(Group::input, "oo")
          .value("KEY=VALUE")
          .list(&InputOptions::openOptions, Type::keyValue)
          .whenUnset("none")
          .advanced()
          .notInDriver("-oo")
          .help("An open option for the driver that reads the DEM."),
      RowBuilder(Group::input, "if")
          .value("FORMAT")
          .list(&InputOptions::inputFormats, Type::text)
          .whenUnset("all")
          .advanced()
          .notInDriver("-if")
          .help("A GDAL driver that may open the DEM."),
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
          .help("The DEM counts depths downwards: 30 lies 30 m below the sea."),
      height("clip-low", &HeightOptions::clipLow, "Raise lower heights to this one."),
      height("clip-high", &HeightOptions::clipHigh, "Lower higher heights to this one."),
      scale("scale-above", &HeightOptions::scaleAbove,
            "Multiplies heights above 0, before clipping."),
      scale("scale-below", &HeightOptions::scaleBelow,
            "Multiplies heights below 0, before clipping."),
      RowBuilder(Group::heights, "void-fill")
          .value("HEIGHT|interpolate")
          .unit("m")
          .custom<HeightOptions>(Type::text, setVoidFill, voidFillText)
          .help("What voids become: a height, or heights interpolated from those around."),
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
          .refusal(
              "terrain lies on the globe, so gdal2tiles' raster profile and other tile matrices "
              "cannot be used")
          .help("The tiles' grid."),
      RowBuilder(Group::tiling, "zoom", 'z')
          .value("MIN-MAX|MIN-|N")
          .custom<TilingOptions>(
              Type::zooms,
              [](TilingOptions& o, const std::string& text) {
                return setZooms(o.minZoom, o.maxZoom, text);
              },
              [](const TilingOptions& o) { return zoomsText(o.minZoom, o.maxZoom); })
          .whenUnset("0 to the DEM's native zoom")
          .help("Zooms to make; N is that one alone, MIN- goes on to the native zoom: the first "
                "with nodes as close as the DEM's cells. 0 to 24."),
      zoomRow("min-zoom", &TilingOptions::minZoom)
          .whenUnset("0")
          .help("The first zoom; CesiumJS needs zoom 0, also where the set lies over another one."),
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
          .help("The finest mesh a tile can have."),
      RowBuilder(Group::tiling, "resampling", 'r')
          .value("METHOD")
          .choice(&InputOptions::resampling)
          .help("How the nodes of the last zoom get heights from the DEM's cells."),
      RowBuilder(Group::tiling, "overview-resampling")
          .value("METHOD")
          .choice(&TilingOptions::overviewResampling)
          .help("How each zoom gets its heights from the next finer one."),
      RowBuilder(Group::tiling, "exclude", 'x')
          .flag(&TilingOptions::excludeVoid)
          .help("Leave out tiles without any height. Else they are filled as --void-fill says."),
      RowBuilder(Group::tiling, "xyz")
          .flag(&OutputOptions::xyz)
          .help("Number tile rows from the north (slippy map) instead of the south (TMS)."),
      RowBuilder(Group::tiling, "tmscompatible", 'd')
          .noEffect("")
          .help("Accepted as in gdal2tiles, always on: two tiles at zoom 0 for geodetic."),
  };
}

Rows meshRows() {
  return {
      RowBuilder(Group::meshes, "normals")
          .flag(&OutputOptions::normals)
          .help("Normals for lit terrain."),
      RowBuilder(Group::meshes, "metadata")
          .value("N")
          .unit("zooms")
          .integer(&OutputOptions::metadata, 0, kMaxZoom)
          .advanced()
          .help("At every N-th zoom, tiles list their descendants of the next N zooms, for clients "
                "that look there; layer.json lists all tiles all the same. 0: none."),
  };
}

Rows outputRows() {
  return {
      RowBuilder(Group::output, "compress")
          .value("HOW")
          .choice(&OutputOptions::compression)
          .help("The tiles' compression."),
      RowBuilder(Group::output, "overwrite")
          .flag(&OutputOptions::overwrite)
          .notInDriver()
          .help("Replace the terrain in OUTPUT once the new one is complete; other files stay. "
                "Else an OUTPUT that is not empty is refused."),
      RowBuilder(Group::output, "webviewer", 'w')
          .value("VIEWER")
          .choice(&OutputOptions::preview)
          .notInDriver()
          .help("A preview page to write beside the tiles."),
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
          .help("The title of the terrain, in layer.json and the preview."),
      RowBuilder(Group::output, "copyright", 'c')
          .value("TEXT")
          .text(&OutputOptions::copyright, Type::text, true)
          .whenUnset("none")
          .help("Whom the heights belong to, in layer.json and the preview."),
      RowBuilder(Group::output, "report")
          .value("FILE")
          .text(&OutputOptions::report, Type::file)
          .whenUnset("none")
          .notInDriver()
          .help("Write a JSON report: tiles, triangles, bytes, errors reached and seconds."),
      RowBuilder(Group::output, "debug-meshes")
          .value("DIR")
          .text(&OutputOptions::debugMeshes, Type::folder)
          .whenUnset("none")
          .advanced()
          .notInDriver()
          .help("Write every tile's mesh to DIR as well, for programs that show meshes: "
                "DIR/{z}/{x}/{y}.ply, metres around the middle of the tile."),
      RowBuilder(Group::output, "debug-format")
          .value("FORMAT")
          .choice(&OutputOptions::debugFormat)
          .advanced()
          .notInDriver()
          .help("The format of --debug-meshes."),
      RowBuilder(Group::output, "force-kml", 'k')
          .noEffect("terrain has no KML")
          .help("Accepted as in gdal2tiles, without effect."),
      RowBuilder(Group::output, "no-kml", 'n')
          .noEffect("terrain has no KML")
          .help("Accepted as in gdal2tiles, without effect."),
      RowBuilder(Group::output, "googlekey", 'g')
          .value("KEY")
          .noEffect("the preview page needs no key", 1)
          .help("Accepted as in gdal2tiles, without effect."),
  };
}

Rows runningRows() {
  return {
      RowBuilder(Group::running, "num-threads", 'j')
          .alias("processes")
          .value("N|ALL_CPUS")
          .custom<RunOptions>(Type::threads, setThreads, threadsText)
          .help("Threads that work."),
      RowBuilder(Group::running, "memory")
          .value("SIZE")
          .custom<RunOptions>(Type::memory, setMemory, memoryText)
          .help("Memory for the work and GDAL's cache: 512MB, 2GB, 40% of the machine's, or "
                "bytes."),
      RowBuilder(Group::running, "block-tiles")
          .value("auto|2|4|8")
          .unit("tiles per block edge")
          .custom<RunOptions>(Type::text, setBlockTiles, blockTilesText)
          .advanced()
          .help("Tiles worked on together; auto goes by memory and threads."),
      RowBuilder(Group::running, "config-file")
          .value("FILE")
          .text(&RunOptions::configFile, Type::file)
          .commandLineOnly()
          .whenUnset("none")
          .help("Read options from a file of lines 'name = value' ('on' or 'off' for one without "
                "value; '#' begins a comment). The command line overrides it."),
      RowBuilder(Group::running, "dry-run")
          .flag(&RunOptions::dryRun)
          .notInDriver()
          .help("Print tiles per zoom and estimates of size and time; write nothing."),
      RowBuilder(Group::running, "compare")
          .flag(&CompareOptions::enabled)
          .notInDriver()
          .help("Compare all methods at the triangle count and at the error of --method: prints a "
                "table and writes comparison.csv and pictures to OUTPUT, no terrain. On the tiles "
                "of --min-x to --max-y, else on the busiest tile of the last zoom."),
      RowBuilder(Group::running, "compare-tile")
          .value("Z/X/Y")
          .custom<CompareOptions>(Type::text, setCompareTile, compareTileText)
          .whenUnset("chosen by --compare")
          .advanced()
          .notInDriver()
          .help("Compare on this tile; the row counts from the south."),
      RowBuilder(Group::running, "quiet", 'q')
          .flag(&RunOptions::quiet)
          .notInDriver()
          .help("Print errors only."),
      RowBuilder(Group::running, "verbose", 'v')
          .flag(&RunOptions::verbose)
          .notInDriver()
          .help("Print what is done."),
  };
}

Rows informationRows() {
  return {
      RowBuilder(Group::information, "help", 'h').request(Request::help).help("Print this text."),
      RowBuilder(Group::information, "version")
          .request(Request::version)
          .help("Print the version."),
      RowBuilder(Group::information, "options-json")
          .request(Request::optionsJson)
          .help("Print all options as JSON, for programs that draw a form."),
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
