// SPDX-License-Identifier: MIT
// Tetrahedra of higher order have nodes on their edges, facets and inside beside their four
// corners. Such a mesh is read by its corners: the other nodes, called mid-side nodes, are not
// points, whatever the format.
#pragma once

#include "cli/formats/file_mesh.hpp"

namespace mgdt::cli {

// Takes the points in `mid_side` that are a corner of no tetrahedron out of the mesh and its
// fields, renumbers the corners, and counts what was taken out in `mid_side_nodes`.
void leave_out_mid_side_nodes(Mesh& mesh);

// "12 mid-side nodes left out", for messages; empty where there are none.
std::string describe_mid_side_nodes(std::size_t n);

}  // namespace mgdt::cli
