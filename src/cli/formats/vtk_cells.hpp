// SPDX-License-Identifier: MIT
// VTK's cell types, from its vtkCellType.h, and which of them are tetrahedra.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "cli/formats/number.hpp"

namespace mgdt::cli {

constexpr std::uint8_t vtk_vertex = 1, vtk_triangle = 5, vtk_tetra = 10, vtk_quadratic_tetra = 24,
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

// The arrays of cell data that have markers. mgdt and OpenGeoSys have names of their own, the
// others are meshio's. Where there is no array for facets, that of the regions has the markers of
// both.
constexpr const char* vtk_region_arrays[] = {"region", "gmsh:physical", "medit:ref", "MaterialIDs"};
constexpr const char* vtk_facet_arrays[] = {"facet"};

// Markers for all cells of a file; the lists are empty if there are none.
struct VtkCellMarkers {
    std::vector<std::int32_t> regions, facets;

    std::int32_t facet(std::size_t cell) const {
        return !facets.empty() ? facets[cell] : !regions.empty() ? regions[cell] : 0;
    }
};

// Adds a cell as facets or segments, if it is one-dimensional or flat. Of higher-order cells, the
// corners are taken, which come first.
inline void add_vtk_facet(std::int64_t type, const std::int64_t* nodes, std::size_t count,
                          FileFacets& facets, std::int32_t marker = 0) {
    constexpr std::int64_t line = 3, poly_line = 4, triangle = 5, strip = 6, polygon = 7, pixel = 8,
                           quad = 9, quadratic_edge = 21, quadratic_triangle = 22,
                           quadratic_quad = 23;
    switch (type) {
        case line:
        case poly_line:
            for (std::size_t k = 0; k + 1 < count; ++k) facets.add_segment(nodes + k);
            break;
        case quadratic_edge:
            if (count >= 2) facets.add_segment(nodes);
            break;
        case triangle:
        case polygon:
        case quad:
            facets.add_facet(nodes, count, marker);
            break;
        case quadratic_triangle:
            if (count >= 3) facets.add_facet(nodes, 3, marker);
            break;
        case quadratic_quad:
            if (count >= 4) facets.add_facet(nodes, 4, marker);
            break;
        case pixel:
            if (count == 4) {
                const std::int64_t around[4] = {nodes[0], nodes[1], nodes[3], nodes[2]};
                facets.add_facet(around, 4, marker);
            }
            break;
        case strip:
            for (std::size_t k = 0; k + 2 < count; ++k) {
                const std::int64_t turn[3] = {nodes[k], nodes[k + 1 + k % 2], nodes[k + 2 - k % 2]};
                facets.add_facet(turn, 3, marker);
            }
            break;
        default:
            break;
    }
}

// Adds a tetrahedron. Its nodes are points of the mesh; corners come first.
inline void add_vtk_tetrahedron(const std::int64_t* nodes, std::size_t count,
                                const VtkCellMarkers& markers, std::size_t cell, Mesh& mesh) {
    for (std::size_t k = 0; k < count; ++k) mesh.add_node(k, nodes[k]);
    if (!markers.regions.empty()) mesh.regions.push_back(markers.regions[cell]);
}

// Converts values to markers. Calls fail(cell, value), which throws, for a value that is none.
template <class Fail>
std::vector<std::int32_t> vtk_markers_of(const std::vector<double>& values, const Fail& fail) {
    std::vector<std::int32_t> markers;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!is_marker(values[i])) fail(i, values[i]);
        markers.push_back(static_cast<std::int32_t>(values[i]));
    }
    return markers;
}

}  // namespace mgdt::cli
