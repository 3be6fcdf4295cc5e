// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "simplify/methods.h"
#ifdef QMESH_WITH_CGAL
#include "simplify/cgal/point_set_methods.h"
#endif

namespace qmesh {

namespace {

/// Bytes for each node that lines may take in addition where they need not be long: they may then
/// meet at every node.
constexpr std::size_t kShortFeatureBytes = 1200;

} // namespace

const std::vector<SimplifierInfo>& simplifiers() {
  static const std::vector<SimplifierInfo> rows = {
      {"greedy", "inserts the worst node until all are within the max error", true, false,
       "max-error", 360, createGreedy},
#ifdef QMESH_WITH_CGAL
      {"collapse", "collapses the cheapest edges of the mesh of all nodes", true, false,
       "max-error", 720, createCollapse},
      {"grid", "keeps sharp edges and one node in each cube of a grid", false, true, "cell-size",
       810, createGridPoints},
      {"random", "keeps sharp edges and a random share of the other nodes", false, true,
       "random-percent", 810, createRandomPoints},
      {"hierarchy", "keeps sharp edges and one node of each small or flat cluster", false, true,
       "cluster-size", 810, createHierarchyPoints},
      {"wlop", "keeps sharp edges and nodes spread evenly over the surface", false, true,
       "retain-percent", 860, createWlopPoints},
#endif
      {"qem", "collapses the edge with the least quadric error until details would show", false,
       false, "svo", 500, createQem},
      {"quadtree",
       "halves cells where the terrain is curved or beyond the max error; regular triangles", false,
       false, "curvature", 450, createQuadtree},
      {"delaunay", "keeps every node: the reference to compare with", false, false, "", 230,
       createAllNodes},
  };
  return rows;
}

std::vector<Choice> simplifierChoices() {
  std::vector<Choice> choices;
  for (const SimplifierInfo& info : simplifiers())
    choices.push_back({info.name, info.sentence});
  return choices;
}

const SimplifierInfo* findSimplifier(const std::string& name) {
  for (const SimplifierInfo& info : simplifiers()) {
    if (name == info.name)
      return &info;
  }
  return nullptr;
}

Result<const SimplifierInfo*> chosenSimplifier(const MethodOptions& options) {
  if (const SimplifierInfo* info = findSimplifier(options.name))
    return info;
  std::vector<std::string> names;
  for (const SimplifierInfo& info : simplifiers())
    names.push_back(info.name);
  return Status(Code::usage,
                "unknown method '" + options.name + "'; this build has " + join(names, ", "));
}

std::size_t bytesPerNode(const SimplifierInfo& info, const MethodOptions& options) {
  const bool shortOnes = options.featureMinSize < MethodOptions().featureMinSize;
  return info.bytesPerNode + (info.keepsFeatures && shortOnes ? kShortFeatureBytes : 0);
}

Status tileFault(TileId tile, const std::string& what) {
  return {Code::internal, "tile " + std::to_string(tile.z) + "/" + std::to_string(tile.x) + "/" +
                              std::to_string(tile.y) + ": " + what};
}

} // namespace qmesh
