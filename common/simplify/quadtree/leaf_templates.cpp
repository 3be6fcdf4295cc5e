// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/quadtree/leaf_templates.h"

namespace qmesh {

namespace {

using Template = std::vector<LeafTriangle>;

/// Turned counter-clockwise by quarters.
Template turned(const Template& triangles, int quarters) {
  Template result = triangles;
  for (LeafTriangle& triangle : result) {
    for (int& place : triangle)
      place = (place + 2 * quarters) % kLeafPlaces;
  }
  return result;
}

/// By middles, then by `rising`.
using TemplateTable = std::array<std::array<Template, 2>, 16>;

TemplateTable makeTable() {
  //   6---5---4
  //   |       |
  //   7       3
  //   |       |
  //   0---1---2
  const Template one = {{1, 2, 4}, {1, 4, 6}, {1, 6, 0}};                         // south
  const Template corner = {{1, 2, 3}, {6, 0, 1}, {6, 1, 3}, {6, 3, 4}};           // south, east
  const Template across = {{0, 1, 5}, {0, 5, 6}, {1, 2, 4}, {1, 4, 5}};           // south, north
  const Template three = {{1, 2, 3}, {3, 4, 5}, {1, 3, 5}, {0, 1, 5}, {0, 5, 6}}; // all but west
  TemplateTable table;
  table[0] = {Template{{0, 2, 6}, {2, 4, 6}}, Template{{0, 2, 4}, {0, 4, 6}}};
  const Template corners = {{1, 2, 3}, {3, 4, 5}, {5, 6, 7}, {7, 0, 1}};
  table[15] = {corners, corners};
  table[15][0].insert(table[15][0].end(), {{1, 3, 7}, {3, 5, 7}});
  table[15][1].insert(table[15][1].end(), {{1, 3, 5}, {1, 5, 7}});
  for (int quarters = 0; quarters < 4; ++quarters) {
    const auto put = [&](int middles, const Template& triangles) {
      const int bits = middles << quarters;
      const Template result = turned(triangles, quarters);
      table[std::size_t((bits | bits >> 4) & 15)] = {result, result};
    };
    put(kSouthMiddle, one);
    put(kSouthMiddle | kEastMiddle, corner);
    put(kSouthMiddle | kNorthMiddle, across);
    put(kSouthMiddle | kEastMiddle | kNorthMiddle, three);
  }
  return table;
}

} // namespace

const std::vector<LeafTriangle>& leafTemplate(int middles, bool rising) {
  static const TemplateTable table = makeTable();
  return table[std::size_t(middles)][rising ? 1 : 0];
}

} // namespace qmesh
