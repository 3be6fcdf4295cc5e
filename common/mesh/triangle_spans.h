// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <utility>

#include "mesh/tile_frame.h"

namespace qmesh {

/// A vertex as the walk over a triangle's nodes wants it.
struct SpanCorner {
  double column = 0;    ///< u in columns of the node lattice: u * N / 32767
  double height = 0;    ///< metres, above whatever level the caller likes
  std::int32_t u = 0;   ///< 0..32767
  std::int32_t v = 0;   ///< 0..32767
  std::int32_t row = 0; ///< first node row at or above v: nodeV(row) >= v
};

/// The column coordinate of a vertex: exactly N at u = 32767.
inline double spanColumn(int u, int cells) {
  return double(u) * cells / kQuantizedMax;
}

/// An edge as a line over v, from its lower end.
class SpanLine {
 public:
  /// REQUIRES: lower.v < upper.v. The ends in this order whichever triangle asks, so that both
  /// owners of an edge find the same bits.
  SpanLine(const SpanCorner& lower, const SpanCorner& upper)
      : column_(lower.column), height_(lower.height), v_(lower.v),
        eastBorder_(lower.u == kQuantizedMax && upper.u == kQuantizedMax) {
    const double scale = 1.0 / (upper.v - lower.v);
    columnSlope_ = (upper.column - lower.column) * scale;
    heightSlope_ = (upper.height - lower.height) * scale;
  }

  double column(double v) const { return column_ + (v - v_) * columnSlope_; }
  double height(double v) const { return height_ + (v - v_) * heightSlope_; }
  int eastBorder() const { return eastBorder_; }

 private:
  double column_;
  double height_;
  double v_;
  int eastBorder_;
  double columnSlope_;
  double heightSlope_;
};

inline int ceilToInt(double x) {
  const int whole = int(x);
  return whole + (double(whole) < x ? 1 : 0);
}

/// Rise of a triangle's plane per column, metres.
inline double heightPerColumn(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                              int cells) {
  const double bu = b.u - a.u, bv = b.v - a.v;
  const double cu = c.u - a.u, cv = c.v - a.v;
  const double perUnit =
      ((b.height - a.height) * cv - (c.height - a.height) * bv) / (bu * cv - bv * cu);
  return perUnit * kQuantizedMax / cells;
}

/// Visits the node rows [first, end) between two edges.
template <class Visit>
inline void forEachRow(const SpanLine& left, const SpanLine& right, int first, int end,
                       const double* nodeV, double slope, Visit& visit) {
  for (int j = first; j < end; ++j) {
    const double from = left.column(nodeV[j]);
    const int i0 = ceilToInt(from);
    const int i1 = ceilToInt(right.column(nodeV[j])) + right.eastBorder();
    if (i0 < i1)
      visit(j, i0, i1, left.height(nodeV[j]) + (i0 - from) * slope);
  }
}

/// Calls visit(j, i0, i1, height) for each node row j that a counter-clockwise triangle covers: its
/// nodes are the columns i0..i1-1, `height` is the plane's at i0, `slope` (heightPerColumn) its
/// rise to the next. A node on an edge belongs to the triangle east or north of it, on the square's
/// east or north border to the one triangle there is: in a TIN every node is visited once.
/// `nodeV`: positions of the N+1 rows.
template <class Visit>
inline void forEachSpan(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                        const double* nodeV, int cells, double slope, Visit&& visit) {
  const SpanCorner *low = &a, *mid = &b, *high = &c;
  bool midEast = true; // counter-clockwise low, mid, high has mid east of the edge low-high
  const auto order = [&midEast](const SpanCorner*& x, const SpanCorner*& y) {
    if (x->v > y->v) {
      std::swap(x, y);
      midEast = !midEast;
    }
  };
  order(low, mid);
  order(mid, high);
  order(low, mid);

  const SpanLine whole(*low, *high);
  if (low->row < mid->row) {
    const SpanLine part(*low, *mid);
    forEachRow(midEast ? whole : part, midEast ? part : whole, low->row, mid->row, nodeV, slope,
               visit);
  }
  if (mid->row < high->row) {
    const SpanLine part(*mid, *high);
    forEachRow(midEast ? whole : part, midEast ? part : whole, mid->row, high->row, nodeV, slope,
               visit);
  }
  if (mid->v == kQuantizedMax) {
    const SpanCorner& west = mid->u < high->u ? *mid : *high;
    const SpanCorner& east = mid->u < high->u ? *high : *mid;
    const int i0 = ceilToInt(west.column);
    const int i1 = ceilToInt(east.column) + (east.u == kQuantizedMax ? 1 : 0);
    if (i0 < i1)
      visit(cells, i0, i1, west.height + (i0 - west.column) * slope);
  }
}

} // namespace qmesh
