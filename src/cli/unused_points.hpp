// SPDX-License-Identifier: MIT
// Points of a mesh that are in no tetrahedron, such as repeats. Solvers stop at nodes without
// elements.
#pragma once

#include <vector>

#include "cli/formats/file_mesh.hpp"

namespace mgdt::cli {

// Removes them. If there are no tetrahedra, all points remain. Returns the new number of each
// point, or -1.
std::vector<MeshIndex> take_out_unused_points(Mesh& mesh);

}  // namespace mgdt::cli
