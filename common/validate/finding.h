// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/enum_table.h"

namespace qmesh {

/// How bad a finding is: an error is seen or breaks clients, a warning breaks some or costs
/// quality, a note is good to know.
enum class Severity { error, warning, note };

/// What a finding is about; the first digit of its code.
enum class FindingGroup { layer = 1, format, mesh, header, seam, availability };

template <> struct EnumTable<Severity> {
  static constexpr EnumRow<Severity> kRows[] = {
      {Severity::error, "error", "breaks clients or is seen"},
      {Severity::warning, "warning", "breaks some clients or costs quality"},
      {Severity::note, "note", "good to know"},
  };
};

template <> struct EnumTable<FindingGroup> {
  static constexpr EnumRow<FindingGroup> kRows[] = {
      {FindingGroup::layer, "layer.json", "the file that says which tiles there are"},
      {FindingGroup::format, "format", "the bytes of a tile"},
      {FindingGroup::mesh, "mesh", "the triangles of a tile"},
      {FindingGroup::header, "header", "the numbers before the vertices"},
      {FindingGroup::seam, "seams", "the edge between two tiles of a level"},
      {FindingGroup::availability, "availability",
       "tiles that are there or are not, and traps of clients"},
  };
};

/// A kind of fault. Codes are stable: none changes its meaning, none is used again.
struct FindingKind {
  int code = 0; ///< 101: QM101
  Severity severity = Severity::error;
  const char* title = "";       ///< a few words
  const char* explanation = ""; ///< one sentence: what it does to clients
  const char* cure = "";        ///< one sentence

  FindingGroup group() const { return FindingGroup(code / 100); }
};

/// All kinds, by code: what the validator can say, its reference page and its JSON.
const std::vector<FindingKind>& findingKinds();

/// REQUIRES: a code of the table.
const FindingKind& findingKind(int code);

/// "QM101".
std::string codeText(int code);

/// The code of "QM101", "qm101" or "101"; 0 where the table has none.
int codeOf(std::string_view text);

/// A fault at a place.
struct Finding {
  int code = 0;
  std::string place; ///< "layer.json", a tile "z/x/y" (row from the south), two tiles, or a file
  std::string what;  ///< the numbers of this one: a sentence without its full stop
};

/// Gathers the findings of one tile, seam or file.
using Findings = std::vector<Finding>;

} // namespace qmesh
