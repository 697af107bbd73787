// SPDX-License-Identifier: MIT
// An unstructured grid as VTK's .vtu files have it, in raw binary. Integers have 32 bits where they
// fit, which halves a file.
#pragma once

#include <cstdint>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "cli/formats/vtk_cells.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

struct Grid {
    const std::vector<double>& points;       // x y z of each
    const std::vector<MeshIndex>* vertices;  // of each cell, `size` of them; nullptr: each point
    std::size_t size;
    std::uint8_t type;
    const std::vector<Field>& fields;      // of the points
    const std::vector<std::int64_t>* ids;  // of the points, an array "point"; or nullptr
    bool is_compressed = false;
};

void write_grid(const Grid& grid, OutputFile& out);

}  // namespace mgdt::cli
