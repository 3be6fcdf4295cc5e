// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/option_rows.h"

#include "options/method_rows.h"
#include "options/row_builder.h"
#include "options/value_grammars.h"

namespace qmesh {

namespace {

using Options = BuildOptions;
using Group = OptionGroup;
using Type = OptionType;
using Rows = std::vector<OptionRow>;

Rows argumentRows() {
  return {
      RowBuilder(Group::arguments, "input")
          .position(1)
          .value("INPUT")
          .text(&Options::input, Type::file)
          .help("The DEM: any raster GDAL reads, heights in one band."),
      RowBuilder(Group::arguments, "output")
          .position(2)
          .value("OUTPUT")
          .text(&Options::output, Type::folder)
          .whenUnset("INPUT's name without extension, in the current folder")
          .help("The folder that becomes the terrain: layer.json and {z}/{x}/{y}.terrain."),
  };
}

Rows inputRows() {
  return {
      RowBuilder(Group::input, "s_srs", 's')
          .value("SRS")
          .text(&Options::sourceSrs, Type::srs)
          .whenUnset("the DEM's own")
          .notInDriver("-a_srs")
          .help("The coordinate system of the DEM, where it has none or a wrong one."),
      RowBuilder(Group::input, "band", 'b')
          .value("N")
          .integer(&Options::band, 1)
          .notInDriver("-b")
          .help("The band with the heights."),
      RowBuilder(Group::input, "srcnodata", 'a')
          .value("NODATA")
          .custom(Type::number, setNodata, nodataText)
          .whenUnset("the DEM's own")
          .notInDriver("-a_nodata")
          .help("The value of cells without a height. NaN and infinite cells never have one."),
      RowBuilder(Group::input, "te")
          .value("XMIN YMIN XMAX YMAX")
          .words(4)
          .custom(Type::extent, setExtent, extentText)
          .whenUnset("all of the DEM")
          .notInDriver("-projwin")
          .help("Use the DEM within this box only, given in --te-srs."),
      RowBuilder(Group::input, "te-srs")
          .value("SRS")
          .text(&Options::extentSrs, Type::srs)
          .whenUnset("that of the DEM")
          .notInDriver("-projwin_srs")
          .help("The coordinate system of --te."),
      RowBuilder(Group::input, "cutline")
          .value("FILE")
          .text(&Options::cutline, Type::file)
          .whenUnset("none")
          .notInDriver()
          .help("Use the DEM within the polygons of this vector file only."),
      RowBuilder(Group::input, "oo")
          .value("KEY=VALUE")
          .list(&Options::openOptions, Type::keyValue)
          .whenUnset("none")
          .advanced()
          .notInDriver("-oo")
          .help("An open option for the driver that reads the DEM."),
      RowBuilder(Group::input, "if")
          .value("FORMAT")
          .list(&Options::inputFormats, Type::text)
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
          .flag(&Options::bathymetry)
          .help("The DEM counts depths downwards: 30 lies 30 m below the sea."),
      height("clip-low", &Options::clipLow, "Raise lower heights to this one."),
      height("clip-high", &Options::clipHigh, "Lower higher heights to this one."),
      scale("scale-above", &Options::scaleAbove, "Multiplies heights above 0, before clipping."),
      scale("scale-below", &Options::scaleBelow, "Multiplies heights below 0, before clipping."),
      RowBuilder(Group::heights, "void-fill")
          .value("HEIGHT|interpolate")
          .unit("m")
          .custom(Type::text, setVoidFill, voidFillText)
          .help("What voids become: a height, or heights interpolated from those around."),
  };
}

RowBuilder zoomRow(const char* name, std::optional<int> Options::*field) {
  return RowBuilder(Group::tiling, name).value("ZOOM").integer(field, 0, kDeepestZoom);
}

RowBuilder tileLimitRow(const char* name, std::optional<std::int64_t> Options::*field,
                        const char* sentence) {
  return RowBuilder(Group::tiling, name)
      .value("TILE")
      .integer(field, 0, (std::int64_t{2} << kDeepestZoom) - 1)
      .whenUnset("no limit")
      .advanced()
      .help(sentence);
}

Rows pyramidRows() {
  return {
      RowBuilder(Group::tiling, "profile", 'p')
          .value("PROFILE")
          .choice(&Options::profile)
          .refusal(
              "terrain lies on the globe, so gdal2tiles' raster profile and other tile matrices "
              "cannot be used")
          .help("The tiles' grid."),
      RowBuilder(Group::tiling, "zoom", 'z')
          .value("MIN-MAX|MIN-|N")
          .custom(Type::zooms, setZooms, zoomsText)
          .whenUnset("0 to the DEM's native zoom")
          .help("Zooms to make; N is that one alone, MIN- goes on to the native zoom: the first "
                "with nodes as close as the DEM's cells. 0 to 24."),
      zoomRow("min-zoom", &Options::minZoom)
          .whenUnset("0")
          .help("The first zoom; CesiumJS needs zoom 0, also where the set lies over another one."),
      zoomRow("max-zoom", &Options::maxZoom)
          .whenUnset("the DEM's native zoom")
          .help("The last zoom."),
      tileLimitRow("min-x", &Options::minX, "The first tile column, at the last zoom."),
      tileLimitRow("max-x", &Options::maxX, "The last tile column, at the last zoom."),
      tileLimitRow("min-y", &Options::minY, "The first tile row from the south, at the last zoom."),
      tileLimitRow("max-y", &Options::maxY, "The last tile row from the south, at the last zoom."),
  };
}

Rows nodeRows() {
  return {
      RowBuilder(Group::tiling, "tilesize")
          .value("CELLS")
          .unit("cells per tile edge")
          .powersOfTwo(kSmallestTile, kLargestTile)
          .custom(Type::integer, setTileSize, tileSizeText)
          .help("The finest mesh a tile can have."),
      RowBuilder(Group::tiling, "resampling", 'r')
          .value("METHOD")
          .choice(&Options::resampling)
          .help("How the nodes of the last zoom get heights from the DEM's cells."),
      RowBuilder(Group::tiling, "overview-resampling")
          .value("METHOD")
          .choice(&Options::overviewResampling)
          .help("How each zoom gets its heights from the next finer one."),
      RowBuilder(Group::tiling, "exclude", 'x')
          .flag(&Options::excludeVoid)
          .help("Leave out tiles without any height. Else they are filled as --void-fill says."),
      RowBuilder(Group::tiling, "xyz")
          .flag(&Options::xyz)
          .help("Number tile rows from the north (slippy map) instead of the south (TMS)."),
      RowBuilder(Group::tiling, "tmscompatible", 'd')
          .noEffect("")
          .help("Accepted as in gdal2tiles, always on: two tiles at zoom 0 for geodetic."),
  };
}

Rows meshRows() {
  return {
      RowBuilder(Group::meshes, "normals").flag(&Options::normals).help("Normals for lit terrain."),
      RowBuilder(Group::meshes, "metadata")
          .value("N")
          .unit("zooms")
          .integer(&Options::metadata, 0, kDeepestZoom)
          .advanced()
          .help("At every N-th zoom, tiles list their descendants of the next N zooms, for clients "
                "that look there; layer.json lists all tiles all the same. 0: none."),
  };
}

Rows outputRows() {
  return {
      RowBuilder(Group::output, "compress")
          .value("HOW")
          .choice(&Options::compression)
          .help("The tiles' compression."),
      RowBuilder(Group::output, "overwrite")
          .flag(&Options::overwrite)
          .notInDriver()
          .help("Replace the terrain in OUTPUT once the new one is complete; other files stay. "
                "Else an OUTPUT that is not empty is refused."),
      RowBuilder(Group::output, "webviewer", 'w')
          .value("VIEWER")
          .choice(&Options::preview)
          .notInDriver()
          .help("A preview page to write beside the tiles."),
      RowBuilder(Group::output, "cesium")
          .value("DIR")
          .text(&Options::cesium, Type::folder)
          .whenUnset("Cesium's download site")
          .notInDriver()
          .help("A CesiumJS build to copy beside the preview page."),
      RowBuilder(Group::output, "title", 't')
          .value("TITLE")
          .text(&Options::title, Type::text, true)
          .whenUnset("the name of INPUT")
          .help("The title of the terrain, in layer.json and the preview."),
      RowBuilder(Group::output, "copyright", 'c')
          .value("TEXT")
          .text(&Options::copyright, Type::text, true)
          .whenUnset("none")
          .help("Whom the heights belong to, in layer.json and the preview."),
      RowBuilder(Group::output, "report")
          .value("FILE")
          .text(&Options::report, Type::file)
          .whenUnset("none")
          .notInDriver()
          .help("Write a JSON report: tiles, triangles, bytes, errors reached and seconds."),
      RowBuilder(Group::output, "debug-meshes")
          .value("DIR")
          .text(&Options::debugMeshes, Type::folder)
          .whenUnset("none")
          .advanced()
          .notInDriver()
          .help("Write every tile's mesh to DIR as well, for programs that show meshes: "
                "DIR/{z}/{x}/{y}.ply, metres around the middle of the tile."),
      RowBuilder(Group::output, "debug-format")
          .value("FORMAT")
          .choice(&Options::debugFormat)
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
          .custom(Type::threads, setThreads, threadsText)
          .help("Threads that work."),
      RowBuilder(Group::running, "memory")
          .value("SIZE")
          .custom(Type::memory, setMemory, memoryText)
          .help("Memory for the work and GDAL's cache: 512MB, 2GB, 40% of the machine's, or "
                "bytes."),
      RowBuilder(Group::running, "block-tiles")
          .value("auto|2|4|8")
          .unit("tiles per block edge")
          .custom(Type::text, setBlockTiles, blockTilesText)
          .advanced()
          .help("Tiles worked on together; auto goes by memory and threads."),
      RowBuilder(Group::running, "config-file")
          .value("FILE")
          .text(&Options::configFile, Type::file)
          .commandLineOnly()
          .whenUnset("none")
          .help("Read options from a file of lines 'name = value' ('on' or 'off' for one without "
                "value; '#' begins a comment). The command line overrides it."),
      RowBuilder(Group::running, "dry-run")
          .flag(&Options::dryRun)
          .notInDriver()
          .help("Print tiles per zoom and estimates of size and time; write nothing."),
      RowBuilder(Group::running, "compare")
          .flag(&Options::compare)
          .notInDriver()
          .help("Compare all methods at the triangle count and at the error of --method: prints a "
                "table and writes comparison.csv and pictures to OUTPUT, no terrain. On the tiles "
                "of --min-x to --max-y, else on the busiest tile of the last zoom."),
      RowBuilder(Group::running, "compare-tile")
          .value("Z/X/Y")
          .custom(Type::text, setCompareTile, compareTileText)
          .whenUnset("chosen by --compare")
          .advanced()
          .notInDriver()
          .help("Compare on this tile; the row counts from the south."),
      RowBuilder(Group::running, "quiet", 'q')
          .flag(&Options::quiet)
          .notInDriver()
          .help("Print errors only."),
      RowBuilder(Group::running, "verbose", 'v')
          .flag(&Options::verbose)
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
