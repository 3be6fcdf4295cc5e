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
      {"greedy", "refinement", "inserts the worst node until all are within the max error", true,
       "max-error", 360, createGreedy},
#ifdef QMESH_WITH_CGAL
      {"collapse", "collapse", "collapses the cheapest edges of the mesh of all nodes", true,
       "max-error", 720, createCollapse},
      {"grid", "point set", "keeps sharp edges and one node in each cube of a grid", false,
       "cell-size", 810, createGridPoints},
      {"random", "point set", "keeps sharp edges and a random share of the other nodes", false,
       "random-percent", 810, createRandomPoints},
      {"hierarchy", "point set", "keeps sharp edges and one node of each small or flat cluster",
       false, "cluster-size", 810, createHierarchyPoints},
      {"wlop", "point set", "keeps sharp edges and nodes spread evenly over the surface", false,
       "retain-percent", 860, createWlopPoints},
#endif
      {"qem", "decimation",
       "collapses the edge with the least quadric error until details would show", false, "svo",
       500, createQem},
      {"quadtree", "refinement",
       "halves cells where the terrain is curved or beyond the max error; regular triangles", false,
       "curvature", 450, createQuadtree},
      {"delaunay", "reference", "keeps every node: the reference to compare with", false, "", 230,
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

std::size_t bytesPerNode(const SimplifierInfo& info, const MethodOptions& options) {
  const bool hasFeatures = info.category == std::string("point set");
  const bool shortOnes = options.featureMinSize < MethodOptions().featureMinSize;
  return info.bytesPerNode + (hasFeatures && shortOnes ? kShortFeatureBytes : 0);
}

Status tileFault(TileId tile, const std::string& what) {
  return {Code::internal, "tile " + std::to_string(tile.z) + "/" + std::to_string(tile.x) + "/" +
                              std::to_string(tile.y) + ": " + what};
}

} // namespace qmesh
