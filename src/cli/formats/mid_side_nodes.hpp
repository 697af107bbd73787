// SPDX-License-Identifier: MIT
// Reduces a mesh of higher-order tetrahedra to its corners. Such tetrahedra have nodes on edges, on
// facets and inside, besides their four corners. These mid-side nodes are not points, whatever the
// format.
#pragma once

#include "cli/formats/file_mesh.hpp"

namespace mgdt::cli {

// Removes the points in `mid_side` that are a corner of no tetrahedron from the mesh and its
// fields, renumbers the corners, and counts the removed points in `mid_side_nodes`.
void leave_out_mid_side_nodes(Mesh& mesh);

// "12 mid-side nodes left out", for messages; empty for 0.
std::string describe_mid_side_nodes(std::size_t n);

}  // namespace mgdt::cli
