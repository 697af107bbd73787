// SPDX-License-Identifier: MIT
// Some tetrahedra of a mesh as a body: its solids, which are connected through facets, and its
// surface.
#pragma once

#include <cstddef>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "cli/formats/surface.hpp"

namespace mgdt::cli {

// For each tetrahedron the number of its solid, from 0, or -1 if it is not in the body. `neighbors`
// has four tetrahedra for each, or -1.
struct Solids {
    std::vector<MeshIndex> of_tetrahedron;
    std::size_t count = 0;
};
Solids find_solids(const std::vector<bool>& is_in_body, const std::vector<MeshIndex>& neighbors);

// The sum of the volumes of the tetrahedra of each solid.
std::vector<double> volumes_of(const Solids& solids, const Mesh& mesh);

// The triangles between the body and what is outside it, each counter-clockwise where it is seen
// from outside, and the lowest corner first. They are sorted.
std::vector<MeshIndex> surface_of(const std::vector<bool>& is_in_body, const Mesh& mesh,
                                  const std::vector<MeshIndex>& neighbors);

// The surface of these triangles, with the points that are corners of it, in their order.
Surface with_own_points(const std::vector<MeshIndex>& triangles, const std::vector<double>& points);

// The number of edges with more than two triangles.
std::size_t count_edges_that_are_not_manifold(const Surface& surface);

// The volume inside a closed surface, and its area.
double volume_inside(const Surface& surface);
double area_of(const Surface& surface);

}  // namespace mgdt::cli
