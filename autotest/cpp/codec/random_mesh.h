// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <random>
#include <string>

#include "codec/tile_mesh.h"

namespace qmesh::test {

/// A grid of columns x rows vertices at random places, each cell cut along a random diagonal, with
/// `extra` more vertices inside triangles; random heights, header, normals and metadata; vertices
/// and triangles numbered at random. Manifold, counter-clockwise, covers the square.
TileMesh randomMesh(std::mt19937& random, std::size_t columns, std::size_t rows,
                    std::size_t extra = 0);

/// The same mesh with other numbers for its vertices and triangles, and other first corners.
TileMesh renumbered(const TileMesh& mesh, std::mt19937& random);

/// Empty where all arrays agree in length and range, else what is wrong.
std::string invalidity(const TileMesh& mesh);

/// All of both but the order of edge lists.
bool sameMesh(const TileMesh& a, const TileMesh& b);

} // namespace qmesh::test
