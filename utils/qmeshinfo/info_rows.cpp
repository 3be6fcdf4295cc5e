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
          .value("TILESET")
          .text(&Options::set, Type::text)
          .essential()
          .help("The tileset: a folder, its layer.json, one .terrain file, or the http(s) URL of "
                "one of them. Also any path that GDAL reads, for example in an archive."),
      Row(Group::description, "json")
          .flag(&Options::json)
          .essential()
          .help("Print JSON (schema: data/schema/qmeshinfo.schema.json) instead of text."),
      Row(Group::description, "stats")
          .flag(&Options::stats)
          .essential()
          .help("Read every tile and print triangles, vertices, bytes and heights per zoom. "
                "Without this option, only layer.json is read."),
      Row(Group::description, "zoom", 'z')
          .value("MIN-MAX|MIN-|N")
          .custom<Options>(
              Type::zooms,
              [](Options& o, const std::string& text) {
                return setZooms(o.minZoom, o.maxZoom, text);
              },
              [](const Options& o) { return zoomsText(o.minZoom, o.maxZoom); })
          .whenUnset("all")
          .essential()
          .help("The zooms to look at. N is one zoom. --sample and --error-raster use the last of "
                "them."),
      Row(Group::validation, "validate")
          .flag(&Options::validate)
          .essential()
          .help("Read every tile and print what is wrong as numbered findings. The exit code is 1 "
                "if a finding is an error."),
      Row(Group::validation, "max-findings")
          .value("N")
          .integer(&Options::maxFindings, 0)
          .help("Locations printed per finding. All are counted. 0: print all."),
      Row(Group::validation, "ignore")
          .value("CODE")
          .list(&Options::ignore, Type::text)
          .whenUnset("none")
          .help("A finding to ignore, for example QM601."),
  };
}

Rows measureRows() {
  return {
      Row(Group::measure, "dem")
          .value("FILE")
          .text(&InputOptions::path, Type::file)
          .whenUnset("none")
          .essential()
          .help("Measure the error of each zoom against this DEM, at the centres of its cells: "
                "largest, mean, root mean square and 99th percentile."),
      Row(Group::measure, "dem-step")
          .value("N")
          .unit("cells")
          .integer(&Options::demStep, 0, 1000000)
          .help("Measure at every N-th column and row. 0: the smallest step that leaves at most 4 "
                "million cells."),
      Row(Group::measure, "error-raster")
          .value("FILE")
          .text(&Options::errorRaster, Type::file)
          .whenUnset("none")
          .essential()
          .help("Write mesh minus DEM at the last zoom of -z as a GeoTIFF, one pixel per measured "
                "cell. Pixels without a tile or a height are nodata."),
  };
}

Rows tileRows() {
  return {
      Row(Group::oneTile, "tile")
          .value("Z/X/Y")
          .custom<Options>(Type::text, setTile, tileText)
          .whenUnset("none")
          .essential()
          .help("Describe one tile of the tileset. Y counts from the south."),
      Row(Group::oneTile, "export")
          .value("FILE")
          .text(&Options::exportFile, Type::file)
          .whenUnset("none")
          .essential()
          .help("Write the tile's mesh as .obj, .ply or .off."),
      Row(Group::oneTile, "frame")
          .value("FRAME")
          .choice(&Options::frame)
          .help("The coordinates of --export."),
      Row(Group::oneTile, "draw")
          .value("FILE")
          .text(&Options::drawing, Type::file)
          .whenUnset("none")
          .essential()
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
          .essential()
          .help("Print the height at a position in degrees, from the deepest tile there. '-' reads "
                "positions from standard input, one per line."),
      Row(Group::information, "list-findings")
          .request(Request::listFindings)
          .help("Print all findings and how to fix them. With --json before it: as JSON."),
  };
}

ProgramText infoProgram() {
  ProgramText text;
  text.name = "qmeshinfo";
  text.arguments = "[options] TILESET";
  text.sentence = "Describes and validates any quantized-mesh tileset and measures its error.";
  text.inputHint = "one tileset per run";
  text.examples = {
      {"qmeshinfo terrain", "The contents of layer.json: zooms, tiles, extensions."},
      {"qmeshinfo --stats -j 4 terrain", "Also triangles, bytes and heights per zoom."},
      {"qmeshinfo --validate terrain", "What is wrong with the tileset, and how to fix it."},
      {"qmeshinfo --validate --json https://example.org/terrain/layer.json",
       "The same for a tileset on a server, as JSON."},
      {"qmeshinfo --dem dem.tif --error-raster error.tif terrain",
       "The error of each zoom against the DEM, and a raster of it."},
      {"qmeshinfo --tile 10/544/718 --export tile.obj --draw tile.png terrain",
       "One tile: header, mesh file and picture."},
      {"qmeshinfo --sample -84.35,36.38 terrain", "The height at a position."},
  };
  text.exitCodes = {
      {0, "done; with --validate: no finding is an error"},
      {1, "--validate found an error; also an internal error, printed on standard error"},
      {2, "usage: an option is unknown, malformed or out of range"},
      {3, "stopped by Ctrl-C or a signal"},
      {4, "the tileset or the DEM cannot be read"},
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
        otherRows(),
        sharedRows({"num-threads", "quiet", "usage", "help", "version", "options-json"})})
    all.insert(all.end(), rows.begin(), rows.end());
  return OptionTable::of(infoProgram(), all);
}

} // namespace qmesh
