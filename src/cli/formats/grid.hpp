// SPDX-License-Identifier: MIT
// Writes an unstructured grid as a .vtu file of VTK in raw binary. Integers have 32 bits if they
// fit, which halves the size.
#pragma once

#include <cstdint>
#include <vector>

#include "cli/formats/file_mesh.hpp"
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
};

void write_grid(const Grid& grid, OutputFile& out);

}  // namespace mgdt::cli
