// SPDX-License-Identifier: MIT
// Writes grids and surfaces as VTK's XML files (.vtu, .vtp). Integers have 32 bits if they fit,
// which halves the size.
#pragma once

#include <cstdint>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "cli/formats/surface.hpp"
#include "cli/formats/vtk_cells.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

struct Grid {
    const std::vector<double>& points;       // x y z of each point
    const std::vector<MeshIndex>* vertices;  // `size` per cell; nullptr: each point is a cell
    std::size_t size;
    std::uint8_t type;
    const std::vector<Field>& fields;      // of the points
    const std::vector<std::int64_t>* ids;  // an id for each point, as an array "point"; or nullptr
    bool is_compressed = false;
    // A number for each cell, as an array "region"; or nullptr. Then there may be triangles, too,
    // as further cells. Their markers are an array "facet". Each array is 0 for cells of the other
    // kind.
    const std::vector<std::int32_t>* regions = nullptr;
    const MarkedFaces* faces = nullptr;
};

void write_grid(const Grid& grid, OutputFile& out);

// Polyhedra that share points.
struct Polyhedra {
    std::vector<double> points;  // x y z of each point
    // The points of each polyhedron, each once. Those of polyhedron i end before offsets[i].
    std::vector<std::int64_t> corners, offsets;
    // For each polyhedron the number of its faces, then for each face the number of its corners and
    // the corners, counter-clockwise where they are seen from outside. Polyhedron i ends before
    // face_offsets[i].
    std::vector<std::int64_t> faces, face_offsets;
    std::vector<std::int64_t> ids;  // the array "point": an id for each polyhedron
    std::vector<Field> measures;    // values for each polyhedron
    bool is_compressed = false;
};

void write_polyhedra(const Polyhedra& polyhedra, OutputFile& out);

// Polygons with their numbers, and lines and points beside them.
struct VtkFacets {
    std::vector<double> points;          // x y z of each point
    std::vector<std::int64_t> vertices;  // points that are shown
    std::vector<std::int64_t> lines;     // 2 points for each
    std::vector<std::int64_t> corners;   // of the polygons
    std::vector<std::int64_t> offsets;   // where the corners of each polygon end
    std::vector<std::int64_t> facets,
        pairs;  // for each polygon: its number, and in how many pairs it is
};

void write_vtk_facets(const VtkFacets& facets, bool is_compressed, OutputFile& out);

void write_vtk_surface(const Surface& surface, bool is_compressed, OutputFile& out);

}  // namespace mgdt::cli
