// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/option_rows.h"
#include "options/row_builder.h"
#include "options/value_grammars.h"
#include "qmeshinfo/info_options.h"

namespace qmesh {

namespace {

using Options = InfoOptions;
using Group = OptionGroup;
using Type = OptionType;
using Rows = std::vector<OptionRow>;
using Row = RowBuilder;

/// The rows of gdal2qmesh that mean the same here.
Rows sharedRows(const std::vector<std::string>& names) {
  Rows shared;
  for (const OptionRow& row : optionRows({}))
    for (const std::string& name : names)
      if (row.name == name)
        shared.push_back(row);
  return shared;
}

Status setTile(Options& options, const std::string& text) {
  const auto tile = parseTileName(text);
  if (!tile.ok())
    return tile.status();
  options.tile = *tile;
  return {};
}

std::string tileText(const Options& options) {
  return tileNameText(options.tile);
}

Rows descriptionRows() {
  return {
      Row(Group::arguments, "set")
          .position(1)
          .value("SET")
          .text(&Options::set, Type::text)
          .help("The terrain: a folder, its layer.json, one .terrain file, or the http(s) address "
                "of one of them; any path that GDAL reads, archives included."),
      Row(Group::description, "json")
          .flag(&Options::json)
          .help("Print JSON (data/schema/qmeshinfo.schema.json) instead of text."),
      Row(Group::description, "stats")
          .flag(&Options::stats)
          .help("Read every tile and tell triangles, vertices, bytes and heights of each level. "
                "Without it only layer.json is read."),
      Row(Group::description, "zoom", 'z')
          .value("MIN-MAX|MIN-|N")
          .custom<Options>(
              Type::zooms,
              [](Options& o, const std::string& text) {
                return setZooms(o.minZoom, o.maxZoom, text);
              },
              [](const Options& o) { return zoomsText(o.minZoom, o.maxZoom); })
          .whenUnset("all")
          .help("Zooms to look at; N is that one alone. With --sample and --error-raster the "
                "deepest of them is used."),
      Row(Group::validation, "validate")
          .flag(&Options::validate)
          .help("Read every tile and list what is wrong, by numbered findings. Exit code 1 when "
                "one is an error."),
      Row(Group::validation, "max-findings")
          .value("N")
          .integer(&Options::maxFindings, 0)
          .help("Places told of each finding; all are counted. 0: all."),
      Row(Group::validation, "ignore")
          .value("CODE")
          .list(&Options::ignore, Type::text)
          .whenUnset("none")
          .help("A finding not to look for, as QM601."),
  };
}

Rows measureRows() {
  return {
      Row(Group::measure, "dem")
          .value("FILE")
          .text(&InputOptions::path, Type::file)
          .whenUnset("none")
          .help("Measure each level against this DEM, at the centres of its cells: largest, mean "
                "and root mean square error and the one 99 % of the cells stay below."),
      Row(Group::measure, "dem-step")
          .value("N")
          .unit("cells")
          .integer(&Options::demStep, 0, 1000000)
          .help("Measure at every N-th column and row; 0 takes the smallest step that leaves at "
                "most 4 million cells, and says which."),
      Row(Group::measure, "error-raster")
          .value("FILE")
          .text(&Options::errorRaster, Type::file)
          .whenUnset("none")
          .help("Write mesh minus DEM of the deepest zoom looked at as a GeoTIFF, one pixel a "
                "cell measured; nodata where there is no tile or no height."),
  };
}

Rows tileRows() {
  return {
      Row(Group::oneTile, "tile")
          .value("Z/X/Y")
          .custom<Options>(Type::text, setTile, tileText)
          .whenUnset("none")
          .help("Describe one tile of the set; the row counts from the south."),
      Row(Group::oneTile, "export")
          .value("FILE")
          .text(&Options::exportFile, Type::file)
          .whenUnset("none")
          .help("Write the tile's mesh as .obj, .ply or .off."),
      Row(Group::oneTile, "frame")
          .value("FRAME")
          .choice(&Options::frame)
          .help("The coordinates of --export."),
      Row(Group::oneTile, "draw")
          .value("FILE")
          .text(&Options::drawing, Type::file)
          .whenUnset("none")
          .help("Draw the tile's triangles as .svg or .png."),
      Row(Group::oneTile, "shade")
          .value("HOW")
          .choice(&Options::shade)
          .help("The colours of --draw."),
      Row(Group::oneTile, "width")
          .value("PIXELS")
          .unit("px")
          .integer(&Options::drawingWidth, 16, 16384)
          .help("The width of --draw."),
  };
}

Rows otherRows() {
  return {
      Row(Group::sampling, "sample")
          .value("LON,LAT")
          .list(&Options::samples, Type::text)
          .whenUnset("none")
          .help("Print the height of the deepest tile there is at a place (degrees); '-' reads "
                "places from standard input, one a line."),
      Row(Group::information, "list-findings")
          .request(Request::listFindings)
          .help("Print every finding there is with its cure; with --json before it, as JSON."),
  };
}

ProgramText infoProgram() {
  ProgramText text;
  text.name = "qmeshinfo";
  text.arguments = "[options] SET";
  text.sentence = "Describes, validates and measures quantized-mesh terrain of any program.";
  text.examples = {
      {"qmeshinfo terrain", "What layer.json says: levels, tiles, extensions."},
      {"qmeshinfo --stats -j 4 terrain", "Triangles, bytes and heights of every level as well."},
      {"qmeshinfo --validate terrain", "What is wrong with the set, and what to do about it."},
      {"qmeshinfo --validate --json https://example.org/terrain/layer.json",
       "The same of a set on a server, for a program."},
      {"qmeshinfo --dem dem.tif --error-raster error.tif terrain",
       "How far each level is from the DEM, and where."},
      {"qmeshinfo --tile 10/544/718 --export tile.obj --draw tile.png terrain",
       "One tile: its header, its mesh for another program, its picture."},
      {"qmeshinfo --sample -84.35,36.38 terrain", "The height at a place."},
  };
  text.exitCodes = {
      {0, "done; with --validate: no finding is an error"},
      {1, "--validate found an error (also: a fault of the program, said on standard error)"},
      {2, "usage: an option is unknown, malformed or out of range"},
      {3, "stopped by Ctrl-C or a signal"},
      {4, "the set or the DEM cannot be read"},
      {5, "a file cannot be written"},
  };
  return text;
}

} // namespace

OptionTable infoTable() {
  Rows all;
  for (const Rows& rows :
       {descriptionRows(), measureRows(),
        sharedRows({"s_srs", "band", "srcnodata", "oo", "if", "bathymetry"}), tileRows(),
        otherRows(), sharedRows({"num-threads", "quiet", "help", "version", "options-json"})})
    all.insert(all.end(), rows.begin(), rows.end());
  return OptionTable::of(infoProgram(), all);
}

} // namespace qmesh
