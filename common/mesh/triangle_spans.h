// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <cstdint>
#include <cstring>
#include <utility>

#include "mesh/lanes.h"
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

/// Twice the signed area of a triangle in (u, v), exact; positive when counter-clockwise.
inline std::int64_t doubledArea(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c) {
  return std::int64_t(b.u - a.u) * (c.v - a.v) - std::int64_t(b.v - a.v) * (c.u - a.u);
}

/// Twice the signed area of the triangle of the origin and two places (members u and v) whose
/// distances from it are within the square's; below 2^31.
template <class Place> std::int32_t cross(const Place& a, const Place& b) {
  return a.u * b.v - a.v * b.u;
}

/// Distance of two vertices in (u, v), squared; exact.
inline std::int64_t squaredLength(const SpanCorner& a, const SpanCorner& b) {
  const std::int64_t u = a.u - b.u, v = a.v - b.v;
  return u * u + v * v;
}

/// True where a vertex lies on no edge of the square.
inline bool isInner(const SpanCorner& corner) {
  return corner.u > 0 && corner.v > 0 && corner.u < kQuantizedMax && corner.v < kQuantizedMax;
}

/// Height of a triangle's plane at a place, metres.
inline double planeHeight(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                          const SpanCorner& place) {
  return (double(doubledArea(b, c, place)) * a.height +
          double(doubledArea(c, a, place)) * b.height +
          double(doubledArea(a, b, place)) * c.height) /
         double(doubledArea(a, b, c));
}

/// Width of a column of nodes in units of u.
inline double unitsPerColumn(int cells) {
  return double(kQuantizedMax) / cells;
}

/// Rise of a triangle's plane per column, metres.
QMESH_INLINE double heightPerColumn(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                                    double columnUnits) {
  const double bu = b.u - a.u, bv = b.v - a.v;
  const double cu = c.u - a.u, cv = c.v - a.v;
  const double rise = (b.height - a.height) * cv - (c.height - a.height) * bv;
  return rise * columnUnits / (bu * cv - bv * cu);
}

/// The nodes of one triangle by rows: those of row `firstRow + k`, k < rows, are the columns
/// begin[k]..end[k]-1 (none where end <= begin); the plane's height at begin[k] is height[k],
/// metres. Rows behind the last hold leftovers.
template <class Real> struct SpanList {
  static constexpr int kMaxRows = 1025 + kLanePadding;

  int firstRow = 0;
  int rows = 0;
  std::int32_t begin[kMaxRows];
  std::int32_t count[kMaxRows];
  Real height[kMaxRows];
};

/// An edge as a line over v, from its lower end: in this order whichever triangle asks, so that
/// both owners of an edge find the same bits. REQUIRES: lower.v < upper.v.
template <class Real> struct SpanLine {
  QMESH_INLINE SpanLine(const SpanCorner& lower, const SpanCorner& upper)
      : column(Real(lower.column)), height(Real(lower.height)), v(Real(lower.v)),
        perUnit(1 / Real(upper.v - lower.v)), columnSlope((Real(upper.column) - column) * perUnit),
        heightSlope((Real(upper.height) - height) * perUnit),
        eastBorder(lower.u == kQuantizedMax && upper.u == kQuantizedMax ? 1 : 0) {}

  Real column;
  Real height;
  Real v;
  Real perUnit;
  Real columnSlope;
  Real heightSlope;
  std::int32_t eastBorder;
};

/// The smallest integers not below numbers >= 0 (by reference: the way of lanes through a call
/// differs between processors).
template <class Real>
QMESH_INLINE void ceilLanes(const typename Lanes<Real>::Reals& x, typename Lanes<Real>::Ints& up) {
  using Ints = typename Lanes<Real>::Ints;
  using Reals = typename Lanes<Real>::Reals;
  up = __builtin_convertvector(x, Ints);
  up -= __builtin_convertvector(__builtin_convertvector(up, Reals) < x, Ints);
}

/// Rows from..to-1.
struct RowRange {
  int from;
  int to;
};

/// Fills rows of the list with what lies between two edges.
template <class Real>
QMESH_INLINE void addRows(const SpanLine<Real>& left, const SpanLine<Real>& right, RowRange rows,
                          const Real* nodeV, Real slope, SpanList<Real>& list) {
  using Reals = typename Lanes<Real>::Reals;
  for (int j = rows.from; j < rows.to; j += Lanes<Real>::kCount) {
    const int k = j - list.firstRow;
    Reals v;
    std::memcpy(&v, nodeV + j, sizeof v);
    const Reals west = left.column + (v - left.v) * left.columnSlope;
    const Reals east = right.column + (v - right.v) * right.columnSlope;
    typename Lanes<Real>::Ints begin, count;
    ceilLanes<Real>(west, begin);
    ceilLanes<Real>(east, count);
    count += right.eastBorder - begin;
    const Reals height = left.height + (v - left.v) * left.heightSlope +
                         (__builtin_convertvector(begin, Reals) - west) * slope;
    std::memcpy(list.begin + k, &begin, sizeof begin);
    std::memcpy(list.count + k, &count, sizeof count);
    std::memcpy(list.height + k, &height, sizeof height);
  }
}

/// Adds the row at the square's north border to a triangle with an edge on it.
template <class Real>
QMESH_INLINE void addTopRow(const SpanCorner& a, const SpanCorner& b, Real slope,
                            SpanList<Real>& list) {
  const SpanCorner& west = a.u < b.u ? a : b;
  const SpanCorner& east = a.u < b.u ? b : a;
  const auto ceiling = [](Real x) {
    const auto whole = std::int32_t(x);
    return whole + (Real(whole) < x ? 1 : 0);
  };
  const int k = list.rows++;
  list.begin[k] = ceiling(Real(west.column));
  list.count[k] = ceiling(Real(east.column)) + (east.u == kQuantizedMax ? 1 : 0) - list.begin[k];
  list.height[k] = Real(west.height) + (Real(list.begin[k]) - Real(west.column)) * slope;
}

/// Lists the nodes a counter-clockwise triangle covers; `slope` is its heightPerColumn. A node on
/// an edge belongs to the triangle east or north of it, on the square's east or north border to the
/// one triangle there is: in a TIN every node belongs to exactly one list. `nodeV`: positions of
/// the N+1 rows and kLanePadding more numbers of any value up to 32767.
template <class Real>
QMESH_INLINE void listSpans(const SpanCorner& a, const SpanCorner& b, const SpanCorner& c,
                            const Real* nodeV, Real slope, SpanList<Real>& list) {
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

  list.firstRow = low->row;
  list.rows = high->row - low->row;
  const SpanLine<Real> whole(*low, *high);
  if (low->row < mid->row) {
    const SpanLine<Real> part(*low, *mid);
    addRows(midEast ? whole : part, midEast ? part : whole, {low->row, mid->row}, nodeV, slope,
            list);
  }
  if (mid->row < high->row) {
    const SpanLine<Real> part(*mid, *high);
    addRows(midEast ? whole : part, midEast ? part : whole, {mid->row, high->row}, nodeV, slope,
            list);
  }
  if (mid->v == kQuantizedMax)
    addTopRow(*mid, *high, slope, list);
}

} // namespace qmesh
