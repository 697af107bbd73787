// SPDX-License-Identifier: MIT
//
// A finite-element mesh of tetrahedra, as the meshes of docs/data are stored.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/point_sets/random_points.hpp"

namespace mgdt::cli {

struct ElementMesh {
    std::vector<Point> nodes;
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;  // Indices of nodes, from 0.
};

// Reads Gmsh's binary MSH 2.2 format, as far as docs/data/mesh.py writes it: nodes numbered from 1
// in their order, then tetrahedra. Throws std::runtime_error.
ElementMesh read_element_mesh(const std::string& path);

}  // namespace mgdt::cli
