// SPDX-License-Identifier: MIT
// The place of the hull that is nearest to a place outside.
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

// In the corner, edge or facet that has the nearest place, by weights that are ratios of exact
// numbers, whatever the order in which the mesh stores it. A coordinate of the place is off by less
// than 2^-53 of itself and 2^-50 of the extent of the corners.
struct HullPlace {
    unsigned size;       // 1 to 3 corners, in the order of the caller's indices
    VertexId corner[3];  // the mean of which, with these weights, is the place
    double weight[3];    // none is negative, and their sum is 1
    double x[3];         // in the mesh's scale
};

// Of q, in the mesh's scale, which is beyond the hull facet of this ghost.
HullPlace nearest_hull_place(const Mesh& mesh, const double* q, TetId ghost);

}  // namespace mgdt
