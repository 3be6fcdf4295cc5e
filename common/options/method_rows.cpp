// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "options/method_rows.h"

#include "options/row_builder.h"
#include "options/value_grammars.h"
#include "pyramid/tiling_options.h"
#include "simplify/method_specs.h"

namespace qmesh {

namespace {

using Options = MethodOptions;
using Group = OptionGroup;
using Type = OptionType;
using Rows = std::vector<OptionRow>;

/// A number per zoom, with the range and unit that methodSpecs() has for it.
RowBuilder specRow(const char* name) {
  const MethodSpec& spec = methodSpec(name);
  return RowBuilder(Group::meshes, name)
      .value("SPEC")
      .unit(spec.unit)
      .spec(spec.field, spec.minimum, spec.maximum);
}

/// One that few users need: the method has a value of its own for each zoom.
RowBuilder advancedSpecRow(const char* name) {
  return specRow(name).whenUnset("by the method").advanced();
}

/// Rows that only these methods look at.
Rows of(const std::vector<std::string>& methods, Rows rows) {
  for (OptionRow& row : rows)
    row.methods = methods;
  return rows;
}

Rows errorRows(const std::vector<Choice>& methods) {
  return {
      RowBuilder(Group::meshes, "method")
          .value("METHOD")
          .choice(&Options::name, methods)
          .help("The method that simplifies the mesh of a tile."),
      specRow("max-error")
          .whenUnset("from --screen-error")
          .essential()
          .help("The largest height difference between the mesh and the heights of its zoom."),
      specRow("screen-error")
          .help("The largest error on the screen in CesiumJS, from which the max error of each "
                "zoom follows. The last zoom takes half of it. --max-error overrides it."),
      RowBuilder(Group::meshes, "border")
          .value("MODE")
          .choice(&TilingOptions::border)
          .advanced()
          .help("How the vertices on the edge between two tiles are chosen."),
      RowBuilder(Group::meshes, "schedule")
          .value("ORDER")
          .choice(&TilingOptions::schedule)
          .advanced()
          .help("The order of the tiles of a zoom with --border inherit."),
  };
}

Rows greedyRows() {
  return of({"greedy"},
            {
                RowBuilder(Group::meshes, "decimate")
                    .value("on|off")
                    .onOff(&Options::decimate)
                    .help("At the end, remove vertices that the max error does not need: 40% fewer "
                          "triangles for 50% more time."),
                RowBuilder(Group::meshes, "error-type")
                    .value("TYPE")
                    .choice(&Options::errorType)
                    .advanced()
                    .help("How the error is measured. With 3d, height errors on slopes may exceed "
                          "the max error. Reports always give height errors."),
                advancedSpecRow("init-grid")
                    .help("Start with a regular grid of this many cells, rounded up to a power of "
                          "two. Its inner nodes stay in the mesh."),
            });
}

Rows collapseRows() {
  const auto weight = [](const char* name, double Options::*field, const char* sentence) {
    return RowBuilder(Group::meshes, name)
        .value("WEIGHT")
        .number(field, 0, 1e6)
        .advanced()
        .help(sentence);
  };
  return of(
      {"collapse"},
      {
          advancedSpecRow("edge-count").help("Stop at this number of edges per tile."),
          advancedSpecRow("edge-ratio")
              .help("Stop at this fraction of the edges of the full mesh."),
          RowBuilder(Group::meshes, "cost")
              .value("COST")
              .choice(&Options::cost)
              .advanced()
              .help("The cost of an edge collapse and the position of the new vertex."),
          RowBuilder(Group::meshes, "space")
              .value("SPACE")
              .choice(&Options::space)
              .advanced()
              .help("The coordinates for the cost."),
          weight("volume-weight", &Options::volumeWeight, "The weight of changes of volume."),
          weight("boundary-weight", &Options::boundaryWeight,
                 "The weight of changes of area at the border."),
          advancedSpecRow("shape-weight")
              .help(
                  "The weight of triangle shape. The default is greater than 0 at low zooms only."),
      });
}

Rows qemRows() {
  return of(
      {"qem"},
      {
          advancedSpecRow("svo").help("Stop at this smallest visible object: the square root of "
                                      "the smallest mean quadric error."),
          advancedSpecRow("ratio").help("Stop at this fraction of the vertices of the full mesh."),
      });
}

Rows quadtreeRows() {
  return of({"quadtree"},
            {
                advancedSpecRow("curvature")
                    .whenUnset("120 times the max error per node spacing; none with --max-error")
                    .help("Divide a cell if its cumulated curvature is greater than this value. "
                          "With --max-error and without --curvature, a cell is divided while it "
                          "has a node beyond the max error."),
                RowBuilder(Group::meshes, "observer")
                    .value("LON,LAT[,HEIGHT]")
                    .custom<Options>(Type::text, setObserver, observerText)
                    .whenUnset("none")
                    .advanced()
                    .help("A position in degrees, with a height in metres. The mesh is finest "
                          "there; thresholds grow with the distance."),
                RowBuilder(Group::meshes, "observer-range")
                    .value("METRES")
                    .unit("m")
                    .number(&Options::observerRange, 1, 2e7)
                    .advanced()
                    .help("The thresholds do not grow within this distance of --observer."),
            });
}

Rows pointRows() {
  return of({"grid", "random", "hierarchy", "wlop"},
            {
                advancedSpecRow("border-max-error")
                    .help("The largest height error of simplified tile edges and features."),
                advancedSpecRow("border-max-length").help("The longest segment on a tile edge."),
                RowBuilder(Group::meshes, "feature-angle")
                    .value("DEGREES")
                    .unit("degrees")
                    .number(&Options::featureAngle, 0, 180)
                    .advanced()
                    .help("An edge of the full mesh is a feature if its dihedral angle is sharper "
                          "than this."),
                RowBuilder(Group::meshes, "feature-min-size")
                    .value("N")
                    .unit("edges")
                    .integer(&Options::featureMinSize, 1)
                    .advanced()
                    .help("Shorter feature lines are ignored."),
            });
}

Rows oneSetRows() {
  return {
      advancedSpecRow("cell-size").methods({"grid"}).help("Keep one point per cube of this size."),
      advancedSpecRow("random-percent")
          .methods({"random"})
          .help("The percentage of points to remove."),
      advancedSpecRow("cluster-size")
          .methods({"hierarchy"})
          .help("Divide clusters with more points."),
      advancedSpecRow("max-variance")
          .methods({"hierarchy"})
          .help("Divide clusters with a larger surface variation."),
      advancedSpecRow("retain-percent").methods({"wlop"}).help("The percentage of points to keep."),
      advancedSpecRow("radius").methods({"wlop"}).help(
          "The radius of the neighbourhood in which points repel each other."),
      RowBuilder(Group::meshes, "iterations")
          .value("N")
          .methods({"wlop"})
          .integer(&Options::iterations, 1, 1000)
          .advanced()
          .help("The number of iterations."),
  };
}

} // namespace

std::vector<OptionRow> methodRows(const std::vector<Choice>& methods) {
  Rows all;
  for (const Rows& rows : {errorRows(methods), greedyRows(), collapseRows(), qemRows(),
                           quadtreeRows(), pointRows(), oneSetRows()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

} // namespace qmesh
