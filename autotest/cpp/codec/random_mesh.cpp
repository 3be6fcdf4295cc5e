// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "random_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace qmesh::test {
namespace {

using Index = std::uint32_t;

std::uint32_t below(std::mt19937& random, std::size_t limit) {
  return std::uint32_t(random() % limit);
}

/// `count` different places from 0 to 32767, both included.
std::vector<std::uint16_t> places(std::mt19937& random, std::size_t count) {
  std::vector<std::uint16_t> chosen;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = 32767 * i / (count - 1);
    const std::size_t gap = 32767 / (count - 1) / 3; // room for more vertices between
    const bool inner = i > 0 && i + 1 < count;
    chosen.push_back(std::uint16_t(from + (inner && gap > 0 ? below(random, gap) : 0)));
  }
  return chosen;
}

void addTriangle(TileMesh& mesh, Index a, Index b, Index c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

void addGrid(TileMesh& mesh, std::mt19937& random, std::size_t columns, std::size_t rows) {
  const auto us = places(random, columns), vs = places(random, rows);
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      mesh.u.push_back(us[i]);
      mesh.v.push_back(vs[j]);
    }
  for (std::size_t j = 0; j + 1 < rows; ++j)
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const Index sw = Index(j * columns + i), se = sw + 1;
      const Index nw = sw + Index(columns), ne = nw + 1;
      if (below(random, 2)) {
        addTriangle(mesh, sw, se, ne);
        addTriangle(mesh, sw, ne, nw);
      } else {
        addTriangle(mesh, sw, se, nw);
        addTriangle(mesh, se, ne, nw);
      }
    }
}

/// Puts a vertex into the middle of triangle t.
void splitTriangle(TileMesh& mesh, std::size_t t) {
  const Index a = mesh.indices[3 * t], b = mesh.indices[3 * t + 1], c = mesh.indices[3 * t + 2];
  const Index middle = Index(mesh.vertexCount());
  mesh.u.push_back(std::uint16_t((mesh.u[a] + mesh.u[b] + mesh.u[c]) / 3));
  mesh.v.push_back(std::uint16_t((mesh.v[a] + mesh.v[b] + mesh.v[c]) / 3));
  mesh.indices[3 * t + 2] = middle;
  addTriangle(mesh, b, c, middle);
  addTriangle(mesh, c, a, middle);
}

void addEdges(TileMesh& mesh) {
  for (Index i = 0; i < mesh.vertexCount(); ++i) {
    if (mesh.u[i] == 0)
      mesh.edges[0].push_back(i);
    if (mesh.v[i] == 0)
      mesh.edges[1].push_back(i);
    if (mesh.u[i] == 32767)
      mesh.edges[2].push_back(i);
    if (mesh.v[i] == 32767)
      mesh.edges[3].push_back(i);
  }
}

double real(std::mt19937& random) {
  return (double(random()) / 4294967296.0 - 0.5) * 1.3e7;
}

Vec3 vector(std::mt19937& random) {
  const double x = real(random), y = real(random);
  return {x, y, real(random)};
}

bool sameVector(const Vec3& a, const Vec3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

bool sameHeader(const TileHeader& a, const TileHeader& b) {
  return sameVector(a.centre, b.centre) && a.minHeight == b.minHeight &&
         a.maxHeight == b.maxHeight && sameVector(a.sphere.centre, b.sphere.centre) &&
         a.sphere.radius == b.sphere.radius && sameVector(a.horizon, b.horizon);
}

} // namespace

TileMesh randomMesh(std::mt19937& random, std::size_t columns, std::size_t rows,
                    std::size_t extra) {
  TileMesh mesh;
  addGrid(mesh, random, columns, rows);
  for (std::size_t k = 0; k < extra; ++k)
    splitTriangle(mesh, k);
  addEdges(mesh);
  for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
    mesh.q.push_back(std::uint16_t(below(random, 32768)));
    mesh.extensions.normals.push_back(std::uint8_t(below(random, 256)));
    mesh.extensions.normals.push_back(std::uint8_t(below(random, 256)));
  }
  mesh.header = {vector(random),
                 float(real(random)),
                 float(real(random)),
                 {vector(random), std::abs(real(random))},
                 vector(random)};
  mesh.extensions.waterMask.assign(below(random, 2) ? 1 : 65536, std::uint8_t(below(random, 256)));
  mesh.extensions.metadata = "{\"available\":[" + std::string(below(random, 30), ' ') + "]}";
  return renumbered(mesh, random);
}

TileMesh renumbered(const TileMesh& mesh, std::mt19937& random) {
  std::vector<Index> to(mesh.vertexCount());
  std::iota(to.begin(), to.end(), 0u);
  std::shuffle(to.begin(), to.end(), random);
  std::vector<std::size_t> triangles(mesh.triangleCount());
  std::iota(triangles.begin(), triangles.end(), std::size_t(0));
  std::shuffle(triangles.begin(), triangles.end(), random);

  TileMesh result = mesh;
  for (std::size_t i = 0; i < to.size(); ++i) {
    result.u[to[i]] = mesh.u[i];
    result.v[to[i]] = mesh.v[i];
    result.q[to[i]] = mesh.q[i];
    result.extensions.normals[2 * to[i]] = mesh.extensions.normals[2 * i];
    result.extensions.normals[2 * to[i] + 1] = mesh.extensions.normals[2 * i + 1];
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::size_t turn = below(random, 3);
    for (std::size_t k = 0; k < 3; ++k)
      result.indices[3 * t + k] = to[mesh.indices[3 * triangles[t] + (k + turn) % 3]];
  }
  for (auto& edge : result.edges) {
    for (Index& index : edge)
      index = to[index];
    std::shuffle(edge.begin(), edge.end(), random);
  }
  return result;
}

std::string invalidity(const TileMesh& mesh) {
  const std::size_t count = mesh.vertexCount();
  if (mesh.v.size() != count || mesh.q.size() != count)
    return "lengths differ";
  if (!mesh.extensions.normals.empty() && mesh.extensions.normals.size() != 2 * count)
    return "wrong number of normals";
  if (mesh.extensions.waterMask.size() > 1 && mesh.extensions.waterMask.size() != 65536)
    return "wrong size of the water mask";
  if (mesh.indices.empty() || mesh.indices.size() % 3 != 0)
    return "no whole triangles";
  for (const auto* values : {&mesh.u, &mesh.v, &mesh.q})
    for (const std::uint16_t value : *values)
      if (value > 32767)
        return "a value above 32767";
  for (const auto* list :
       {&mesh.indices, &mesh.edges[0], &mesh.edges[1], &mesh.edges[2], &mesh.edges[3]})
    for (const Index index : *list)
      if (index >= count)
        return "an index out of range";
  return std::isfinite(mesh.header.minHeight) && std::isfinite(mesh.header.maxHeight)
             ? ""
             : "a height that is not a number";
}

bool sameMesh(const TileMesh& a, const TileMesh& b) {
  for (std::size_t e = 0; e < 4; ++e)
    if (std::multiset<Index>(a.edges[e].begin(), a.edges[e].end()) !=
        std::multiset<Index>(b.edges[e].begin(), b.edges[e].end()))
      return false;
  return sameHeader(a.header, b.header) && a.u == b.u && a.v == b.v && a.q == b.q &&
         a.indices == b.indices && a.extensions == b.extensions;
}

} // namespace qmesh::test
