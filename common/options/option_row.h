// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_table.h"
#include "base/status.h"
#include "options/option_structs.h"

namespace qmesh {

/// Where the help shows an option; the order is that of the help.
enum class OptionGroup {
  arguments,
  description,
  validation,
  measure,
  input,
  heights,
  oneTile,
  sampling,
  tiling,
  meshes,
  output,
  running,
  information,
};

/// What a value looks like, for programs that draw a form.
enum class OptionType {
  flag,
  integer,
  number,
  text,
  choice,
  spec,
  zooms,
  memory,
  threads,
  srs,
  extent,
  file,
  folder,
  keyValue,
};

/// What a command line asks for.
enum class Request { run, briefHelp, help, version, optionsJson, listFindings };

template <> struct EnumTable<OptionGroup> {
  static constexpr EnumRow<OptionGroup> kRows[] = {
      {OptionGroup::arguments, "Arguments", "the input and the output"},
      {OptionGroup::description, "Description", "what is printed about a tileset"},
      {OptionGroup::validation, "Validation", "what is wrong with a tileset"},
      {OptionGroup::measure, "Measuring", "the error of a tileset against its DEM"},
      {OptionGroup::input, "Input", "how the DEM is read"},
      {OptionGroup::heights, "Heights", "how heights are changed"},
      {OptionGroup::oneTile, "One tile", "header, mesh and picture of one tile"},
      {OptionGroup::sampling, "Sampling", "heights at positions"},
      {OptionGroup::tiling, "Tiling", "which tiles are made, and how nodes get heights"},
      {OptionGroup::meshes, "Meshes", "how the mesh of a tile is simplified"},
      {OptionGroup::output, "Output", "what is written"},
      {OptionGroup::running, "Running", "how the program runs; the tiles do not depend on it"},
      {OptionGroup::information, "Information", "printed instead of a run"},
  };
};

template <> struct EnumTable<OptionType> {
  static constexpr EnumRow<OptionType> kRows[] = {
      {OptionType::flag, "flag", "on or off; takes no value on the command line"},
      {OptionType::integer, "integer", "whole number"},
      {OptionType::number, "number", "decimal number"},
      {OptionType::text, "text", "any text"},
      {OptionType::choice, "choice", "one of the choices"},
      {OptionType::spec, "spec", "number that may differ per zoom"},
      {OptionType::zooms, "zooms", "MIN-MAX, MIN- or N"},
      {OptionType::memory, "memory", "512MB, 2GB, 40% or bytes"},
      {OptionType::threads, "threads", "whole number or ALL_CPUS"},
      {OptionType::srs, "srs", "EPSG:N, WKT or PROJ text"},
      {OptionType::extent, "extent", "XMIN YMIN XMAX YMAX"},
      {OptionType::file, "file", "path of a file"},
      {OptionType::folder, "folder", "path of a folder"},
      {OptionType::keyValue, "keyvalue", "KEY=VALUE"},
  };
};

/// All there is to know about one option: it feeds the parser, the help, the JSON, and the forms
/// and pages made from them.
struct OptionRow {
  std::string name;                 ///< long name without dashes; '_' and '-' read alike
  char letter = 0;                  ///< 0: none
  std::vector<std::string> aliases; ///< other long names
  OptionGroup group = OptionGroup::arguments;
  OptionType type = OptionType::flag;
  std::string placeholder;          ///< of the value in the help; empty for a flag
  std::string unit;                 ///< of a number; empty: none
  std::optional<double> minimum;    ///< of a number, inclusive
  std::optional<double> maximum;    ///< of a number, inclusive
  std::vector<Choice> choices;      ///< of a choice
  std::string help;                 ///< what it does, one or two sentences
  std::string whenUnset;            ///< said for the default where the field is empty
  std::string refusal;              ///< added to the message about a bad value; may be empty
  std::string ignored;              ///< why it has no effect; empty: it has one
  int values = 1;                   ///< words it takes on a command line, 0 for a flag
  int position = 0;                 ///< 1, 2: an argument without a name; 0: an option
  std::string initial;              ///< the default as text; empty where the field is
  bool essential = false;           ///< most users need it: shown by -h, too
  bool advanced = false;            ///< few users need it
  bool repeatable = false;          ///< each use adds a value
  bool commandLineOnly = false;     ///< means nothing in a file or a form
  bool notInDriver = false;         ///< no creation option of the GDAL driver
  std::vector<std::string> methods; ///< that it belongs to; empty: all
  std::string translateOption;      ///< of gdal_translate, that does the same where notInDriver
  Request request = Request::run;   ///< of the rows that ask for something else than a run

  /// Reads a value into its field; a flag takes "on", "off" and their aliases. On a fault the
  /// status says what was expected, without naming option and value: the caller knows them.
  std::function<Status(const OptionStructs&, const std::string&)> set;
  /// The field as text that set() reads; empty where the field is.
  std::function<std::string(const ConstOptionStructs&)> get;

  /// The default as text: the field of default-constructed options.
  std::string defaultText() const { return initial; }
  /// "1 to 5 m", "1 or more", "m", or nothing. Choices say more than a range.
  std::string rangeText() const;
  /// "method collapse", "methods grid, wlop", or nothing.
  std::string methodsText() const;
  /// Whether the GDAL driver takes it as a creation option.
  bool isCreationOption() const { return position == 0 && !commandLineOnly && !notInDriver; }
  /// The name of a GDAL creation option: MAX_ERROR for max-error.
  std::string creationOption() const;
};

} // namespace qmesh
