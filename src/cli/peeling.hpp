// SPDX-License-Identifier: MIT
// Takes flat tetrahedra off the hull of a mesh. The skin of points with rounded coordinates has
// such tetrahedra, of points that were in one plane.
#pragma once

#include <vector>

#include "cli/formats/file_mesh.hpp"

namespace mgdt::cli {

// For each tetrahedron whether it stays when those with a radius ratio below `tolerance` are taken
// off the hull, one layer after another. `neighbors` has four tetrahedra for each, or -1.
std::vector<bool> find_what_stays(const std::vector<double>& radius_ratios,
                                  const std::vector<MeshIndex>& neighbors, double tolerance);

// Keeps the rows of four numbers, one row for each tetrahedron, of those that stay.
void keep_rows(const std::vector<bool>& stays, std::vector<MeshIndex>& rows);
// The same for neighbours, whose numbers are changed: -1 stands for what does not stay.
void keep_neighbors(const std::vector<bool>& stays, std::vector<MeshIndex>& neighbors);

}  // namespace mgdt::cli
