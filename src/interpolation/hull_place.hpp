// SPDX-License-Identifier: MIT
// The point of the convex hull that is nearest to a point outside.
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

// The nearest point, as a weighted mean of the corners of the vertex, edge or facet that contains
// the point. The weights are ratios of exact numbers and do not depend on the order in which the
// mesh is stored. The error of a coordinate of the point is below 2^-53 of the coordinate plus
// 2^-50 of the extent of the corners.
struct HullPlace {
    unsigned size;       // 1 to 3 corners, in the order of the caller's indices
    VertexId corner[3];  // the corners whose weighted mean is the point
    double weight[3];    // non-negative; their sum is 1
    double x[3];         // the coordinates of the point in the mesh's scale
};

// The point of the hull that is nearest to q. The coordinates of q are in the mesh's scale, and q
// is beyond the hull facet of `ghost`.
HullPlace nearest_hull_place(const Mesh& mesh, const double* q, TetId ghost);

}  // namespace mgdt
