// SPDX-License-Identifier: MIT
//
// Local refinement of a finite-element mesh, as adaptive analysis does it: edges near a feature are
// bisected until they are as short as wanted there, with spacing that grows gradually away from it.
#pragma once

#include <cstddef>
#include <vector>

#include "cli/element_mesh.hpp"
#include "cli/point_sets/random_points.hpp"

namespace mgdt::cli {

// The wanted spacing is proportional to 1 + (distance from the centre / radius)^2.
struct Focus {
    Point centre;
    double radius;
};

// The nodes of the mesh, refined until there are exactly n: those of the mesh first, then the
// midpoints of edges in the order of their making. If the mesh has n or more, its first n.
std::vector<Point> refine(ElementMesh mesh, const Focus& focus, std::size_t n);

}  // namespace mgdt::cli
