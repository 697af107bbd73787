// SPDX-License-Identifier: MIT
// The convex hull of vertices that are all at one point, on one line or in one plane.
#pragma once

#include "mesh/mesh.hpp"
#include "predicates/long_number.hpp"

namespace mgdt {

class FlatHull {
  public:
    // The hull of the vertices of a mesh without tetrahedra. The mesh must outlive the hull. The
    // time is linear in the number of vertices.
    FlatHull(const Mesh& mesh, Allocator& allocator);

    // Whether the closed hull contains q, which is in the mesh's scale. The answer is exact. In a
    // plane, the test is linear in the number of vertices.
    bool contains(const double* q);

  private:
    // The orientation of p, q, r, projected along an axis that is not parallel to their plane.
    int turn(const double* p, const double* q, const double* r);
    // Whether q, on the line through p and r, is between them.
    bool is_between(const double* p, const double* q, const double* r) const;

    const Mesh& mesh_;
    LongMemory memory_;
    int dimension_ = -1;
    const double* span_[3] = {};  // vertices that span the hull's line or plane
    const double* ends_[2] = {};  // the lexicographically first and last vertex
    int axis_ = 0;
};

}  // namespace mgdt
