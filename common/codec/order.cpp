// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <algorithm>
#include <utility>

#include "codec/encode.h"

namespace qmesh {
namespace {

using Index = std::uint32_t;
constexpr Index kNone = ~Index(0);

/// Half-edge h runs from corner h of the index array to the next corner of its triangle.
Index next(Index h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
Index previous(Index h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}

/// An edge by its two vertices, whichever way it runs.
struct EdgeName {
  Index low;
  Index high;
  bool operator==(const EdgeName& o) const { return ((low ^ o.low) | (high ^ o.high)) == 0; }
};

/// The edge of every half-edge.
std::vector<EdgeName> nameEdges(const std::vector<Index>& indices) {
  std::vector<EdgeName> edges(indices.size());
  for (std::size_t h = 0; h < indices.size(); h += 3) {
    const Index a = indices[h], b = indices[h + 1], c = indices[h + 2];
    edges[h] = {std::min(a, b), std::max(a, b)};
    edges[h + 1] = {std::min(b, c), std::max(b, c)};
    edges[h + 2] = {std::min(c, a), std::max(c, a)};
  }
  return edges;
}

/// Where each vertex's share begins in an array of half-edges sorted by vertex, from how many it
/// has.
void countsToStarts(std::vector<Index>& counts) {
  Index sum = 0;
  for (Index& count : counts)
    count = std::exchange(sum, sum + count);
}

/// The half-edges sorted by edge: by the higher vertex, then, keeping that order, by the lower. Two
/// counting sorts take linear time and, unlike lists per vertex, no branch that cannot be foretold.
std::vector<Index> sortByEdge(const std::vector<EdgeName>& edges, std::size_t vertexCount) {
  const Index count = Index(edges.size());
  std::vector<Index> lowStart(vertexCount, 0), highStart(vertexCount, 0);
  for (const EdgeName& edge : edges) {
    ++lowStart[edge.low];
    ++highStart[edge.high];
  }
  countsToStarts(lowStart);
  countsToStarts(highStart);
  std::vector<Index> byHigh(count), byEdge(count);
  for (Index h = 0; h < count; ++h)
    byHigh[highStart[edges[h].high]++] = h;
  for (const Index h : byHigh)
    byEdge[lowStart[edges[h].low]++] = h;
  return byEdge;
}

/// For every half-edge the one that runs along the same edge in the triangle beyond, or kNone.
std::vector<Index> findTwins(const std::vector<Index>& indices, std::size_t vertexCount) {
  const std::vector<EdgeName> edges = nameEdges(indices);
  const std::vector<Index> byEdge = sortByEdge(edges, vertexCount);
  std::vector<Index> twins(indices.size(), kNone);
  for (std::size_t i = 1; i < byEdge.size(); ++i) {
    const Index g = byEdge[i - 1];
    const Index h = byEdge[i];
    if (edges[g] == edges[h]) {
      twins[g] = h;
      twins[h] = g;
    }
  }
  return twins;
}

/// The half-edge without a twin that begins nearest to the south-west corner, so that the result
/// does not depend on how the mesh was numbered.
Index findStart(const TileMesh& mesh, const std::vector<Index>& twins) {
  Index start = 0;
  std::uint64_t least = ~std::uint64_t(0);
  for (Index h = 0; h < twins.size(); ++h) {
    if (twins[h] != kNone)
      continue;
    const Index vertex = mesh.indices[h];
    const std::uint64_t place = std::uint64_t(mesh.v[vertex]) << 16 | mesh.u[vertex];
    if (place < least) {
      least = place;
      start = h;
    }
  }
  return start;
}

/// Walks over the triangles and numbers vertices and triangles as it meets them.
class Walk {
 public:
  Walk(const std::vector<Index>& indices, const std::vector<Index>& twins, std::size_t vertexCount)
      : indices_(indices), twins_(twins), done_(indices.size() / 3, 0),
        newNumber_(vertexCount, kNone) {
    newIndices_.reserve(indices.size());
    oldNumber_.reserve(vertexCount);
  }

  /// Everything connected with the triangle of half-edge `start`: always on across the edge that
  /// follows the one it came in by, which goes round a vertex in a fan, else across the third.
  void run(Index start) {
    stack_.push_back(start);
    while (!stack_.empty()) {
      Index h = stack_.back();
      stack_.pop_back();
      while (isFresh(h)) {
        take(h);
        const Index first = twins_[next(h)];
        const Index second = twins_[previous(h)];
        if (!isFresh(first)) {
          h = second;
          continue;
        }
        if (isFresh(second))
          stack_.push_back(second);
        h = first;
      }
    }
  }

  std::vector<Index> takeIndices() { return std::move(newIndices_); }
  const std::vector<Index>& newNumber() const { return newNumber_; }
  const std::vector<Index>& oldNumber() const { return oldNumber_; }

 private:
  bool isFresh(Index h) const { return h != kNone && !done_[h / 3]; }

  void take(Index h) {
    done_[h / 3] = 1;
    takeCorner(indices_[h]);
    takeCorner(indices_[next(h)]);
    takeCorner(indices_[previous(h)]);
  }

  void takeCorner(Index vertex) {
    if (newNumber_[vertex] == kNone) {
      newNumber_[vertex] = Index(oldNumber_.size());
      oldNumber_.push_back(vertex);
    }
    newIndices_.push_back(newNumber_[vertex]);
  }

  const std::vector<Index>& indices_;
  const std::vector<Index>& twins_;
  std::vector<std::uint8_t> done_; ///< a triangle
  std::vector<Index> newNumber_;   ///< of an old vertex
  std::vector<Index> oldNumber_;   ///< of a new vertex
  std::vector<Index> newIndices_;
  std::vector<Index> stack_; ///< half-edges of triangles to come back to
};

template <class T> std::vector<T> gather(const std::vector<T>& from, const std::vector<Index>& at) {
  std::vector<T> to(at.size());
  for (std::size_t i = 0; i < at.size(); ++i)
    to[i] = from[at[i]];
  return to;
}

void reorderVertices(TileMesh& mesh, const std::vector<Index>& oldNumber) {
  mesh.u = gather(mesh.u, oldNumber);
  mesh.v = gather(mesh.v, oldNumber);
  mesh.q = gather(mesh.q, oldNumber);
  if (mesh.extensions.normals.empty())
    return;
  std::vector<std::uint8_t> normals(2 * oldNumber.size());
  for (std::size_t i = 0; i < oldNumber.size(); ++i) {
    normals[2 * i] = mesh.extensions.normals[2 * oldNumber[i]];
    normals[2 * i + 1] = mesh.extensions.normals[2 * oldNumber[i] + 1];
  }
  mesh.extensions.normals = std::move(normals);
}

void sortBy(std::vector<Index>& edge, const std::vector<std::uint16_t>& place, bool ascending) {
  std::sort(edge.begin(), edge.end(), [&](Index a, Index b) {
    return ascending ? place[a] < place[b] : place[b] < place[a];
  });
}

} // namespace

void orderForEncoding(TileMesh& mesh) {
  if (mesh.indices.empty())
    return;
  const std::vector<Index> twins = findTwins(mesh.indices, mesh.vertexCount());
  Walk walk(mesh.indices, twins, mesh.vertexCount());
  walk.run(findStart(mesh, twins));
  for (Index h = 0; h < mesh.indices.size(); h += 3)
    walk.run(h); // what hangs together with the rest by vertices only, or not at all

  mesh.indices = walk.takeIndices();
  reorderVertices(mesh, walk.oldNumber());
  for (auto& edge : mesh.edges)
    for (Index& vertex : edge)
      vertex = walk.newNumber()[vertex];
  sortBy(mesh.edges[0], mesh.v, true);
  sortBy(mesh.edges[1], mesh.u, false);
  sortBy(mesh.edges[2], mesh.v, false);
  sortBy(mesh.edges[3], mesh.u, true);
}

} // namespace qmesh
