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
          .help("How triangles are chosen."),
      specRow("max-error")
          .whenUnset("as --screen-error says")
          .help("The largest height difference between the mesh and the heights of its zoom."),
      specRow("screen-error")
          .help("The largest error where CesiumJS shows a zoom, in pixels of the screen; the last "
                "zoom takes half of it. --max-error overrides it."),
      RowBuilder(Group::meshes, "border")
          .value("MODE")
          .choice(&TilingOptions::border)
          .advanced()
          .help("Who decides the vertices of the edge between two tiles."),
      RowBuilder(Group::meshes, "schedule")
          .value("ORDER")
          .choice(&TilingOptions::schedule)
          .advanced()
          .help("The order of a zoom's tiles under --border inherit."),
  };
}

Rows greedyRows() {
  return of(
      {"greedy"},
      {
          RowBuilder(Group::meshes, "decimate")
              .value("on|off")
              .onOff(&Options::decimate)
              .help("greedy: afterwards remove the vertices the error does not need: two fifths "
                    "fewer "
                    "triangles for half as much more time."),
          RowBuilder(Group::meshes, "error-type")
              .value("TYPE")
              .choice(&Options::errorType)
              .advanced()
              .help("greedy: how the distance of a node from the mesh is measured. With 3d the "
                    "height "
                    "error "
                    "may exceed the max error on slopes; reports tell the height error all the "
                    "same."),
          advancedSpecRow("init-grid")
              .help(
                  "greedy: begin with a grid of so many cells, rounded up to a power of two, whose "
                  "inner "
                  "nodes stay."),
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
  return of({"collapse"},
            {
                advancedSpecRow("edge-count").help("collapse: stop at so many edges a tile."),
                advancedSpecRow("edge-ratio")
                    .help("collapse: stop at this share of the full mesh's edges."),
                RowBuilder(Group::meshes, "cost")
                    .value("COST")
                    .choice(&Options::cost)
                    .advanced()
                    .help("collapse: what an edge's collapse costs and where its vertex goes."),
                RowBuilder(Group::meshes, "space")
                    .value("SPACE")
                    .choice(&Options::space)
                    .advanced()
                    .help("collapse: the coordinates it works in."),
                weight("volume-weight", &Options::volumeWeight,
                       "collapse: weight of the volume that changes."),
                weight("boundary-weight", &Options::boundaryWeight,
                       "collapse: weight of the area that changes at the border."),
                advancedSpecRow("shape-weight")
                    .help("collapse: weight of the triangles' shape; more than 0 at low zooms."),
            });
}

Rows qemRows() {
  return of(
      {"qem"},
      {
          advancedSpecRow("svo").help(
              "qem: the smallest visible object, where it stops: the square root of the mean "
              "least quadric error."),
          advancedSpecRow("ratio").help("qem: stop at this share of the full mesh's vertices."),
      });
}

Rows quadtreeRows() {
  return of(
      {"quadtree"},
      {
          advancedSpecRow("curvature")
              .whenUnset("120 max errors per node spacing; none where --max-error is given")
              .help("quadtree: divide a cell while its cumulated curvature exceeds this; without "
                    "it and "
                    "with --max-error, while a node is beyond that."),
          RowBuilder(Group::meshes, "observer")
              .value("LON,LAT[,HEIGHT]")
              .custom<Options>(Type::text, setObserver, observerText)
              .whenUnset("none")
              .advanced()
              .help("quadtree: a place in degrees (height in metres) around which the mesh stays "
                    "fine; "
                    "thresholds grow with the distance from it."),
          RowBuilder(Group::meshes, "observer-range")
              .value("METRES")
              .unit("m")
              .number(&Options::observerRange, 1, 2e7)
              .advanced()
              .help("quadtree: within this distance of the observer the thresholds are as given."),
      });
}

Rows pointRows() {
  return of(
      {"grid", "random", "hierarchy", "wlop"},
      {
          advancedSpecRow("border-max-error")
              .help("point sets: the largest height error of the simplified edges and features."),
          advancedSpecRow("border-max-length")
              .help("point sets: the longest piece of a tile edge."),
          RowBuilder(Group::meshes, "feature-angle")
              .value("DEGREES")
              .unit("degrees")
              .number(&Options::featureAngle, 0, 180)
              .advanced()
              .help("point sets: edges with a sharper angle between their triangles are features."),
          RowBuilder(Group::meshes, "feature-min-size")
              .value("N")
              .unit("edges")
              .integer(&Options::featureMinSize, 1)
              .advanced()
              .help("point sets: shorter feature lines are left out."),
      });
}

Rows oneSetRows() {
  return {
      advancedSpecRow("cell-size")
          .methods({"grid"})
          .help("grid: one point is kept in each cube of this size."),
      advancedSpecRow("random-percent").methods({"random"}).help("random: points removed."),
      advancedSpecRow("cluster-size")
          .methods({"hierarchy"})
          .help("hierarchy: a cluster of more points is divided."),
      advancedSpecRow("max-variance")
          .methods({"hierarchy"})
          .help("hierarchy: a cluster with a larger surface variation is divided."),
      advancedSpecRow("retain-percent").methods({"wlop"}).help("wlop: points left."),
      advancedSpecRow("radius").methods({"wlop"}).help(
          "wlop: the neighbourhood in which points push each other apart."),
      RowBuilder(Group::meshes, "iterations")
          .value("N")
          .methods({"wlop"})
          .integer(&Options::iterations, 1, 1000)
          .advanced()
          .help("wlop: rounds of moving the points."),
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
