// SPDX-License-Identifier: MIT
// VTK's cell types, from its vtkCellType.h, and which of them are tetrahedra.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cli/formats/file_mesh.hpp"

namespace mgdt::cli {

constexpr std::uint8_t vtk_vertex = 1, vtk_tetra = 10, vtk_quadratic_tetra = 24,
                       vtk_polyhedron = 42, vtk_lagrange_tetra = 71, vtk_bezier_tetra = 79;

inline bool is_vtk_tetrahedron(std::int64_t type) {
    return type == vtk_tetra || type == vtk_quadratic_tetra || type == vtk_lagrange_tetra ||
           type == vtk_bezier_tetra;
}

// Whether a cell of this type may have this number of nodes. Of higher-order types, only tetrahedra
// are checked.
inline bool may_have_nodes(std::int64_t type, std::size_t nodes) {
    // 0 stands for any number or an unknown type.
    constexpr std::size_t linear[] = {0, 1, 0, 2, 0, 3, 0, 0, 4, 4, 4, 8, 8, 6, 5};
    if (type >= 0 && type < 15) return linear[type] == 0 || nodes == linear[type];
    if (type == vtk_quadratic_tetra) return nodes == 10;
    return !is_vtk_tetrahedron(type) || nodes >= 4;
}

// Adds the nodes of a tetrahedron, which are points of the mesh. Corners come first.
inline void add_vtk_tetrahedron(const std::int64_t* nodes, std::size_t count, Mesh& mesh) {
    for (std::size_t k = 0; k < count; ++k) mesh.add_node(k, nodes[k]);
}

}  // namespace mgdt::cli
