// SPDX-License-Identifier: MIT
// The convex hull of vertices that are all at one place, on one line or in one plane.
#pragma once

#include "mesh/mesh.hpp"
#include "predicates/long_number.hpp"

namespace mgdt {

class FlatHull {
  public:
    // Of a mesh without tetrahedra, which stays as it is. Takes time in proportion to its vertices.
    FlatHull(const Mesh& mesh, Allocator& allocator);

    // Whether the closed hull contains q, a place in the mesh's scale, exactly. In a plane it takes
    // time in proportion to the vertices.
    bool contains(const double* q);

  private:
    // Sign of the area of p, q, r in the direction of an axis along which the plane's normal has an
    // extent.
    int turn(const double* p, const double* q, const double* r);
    // Whether q, on the line through p and r, is between them.
    bool is_between(const double* p, const double* q, const double* r) const;

    const Mesh& mesh_;
    LongMemory memory_;
    int dimension_ = -1;
    const double* span_[3] = {};  // vertices that span the hull's line or plane
    const double* ends_[2] = {};  // the first and last vertex in the order of coordinates
    int axis_ = 0;
};

}  // namespace mgdt
