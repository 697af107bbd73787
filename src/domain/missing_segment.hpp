// SPDX-License-Identifier: MIT
// Whether a segment between two vertices is an edge of a Delaunay triangulation and, if it is not,
// a vertex that keeps it from being one.
#pragma once

#include "core/triangulation.hpp"
#include "query/locate.hpp"
#include "query/visit_queue.hpp"

namespace mgdt {

class MissingSegment {
  public:
    MissingSegment(const Triangulation& triangulation, Allocator& allocator);

    // Returns whether the segment between points a and b is missing, and finds reference() if it
    // is. The time grows with the star of a; the result does not depend on the order of a and b.
    // The search starts at `at_a` if that is a tetrahedron of a, and locates one otherwise.
    bool find(std::uint32_t a, std::uint32_t b, TetId at_a = no_tetrahedron);
    // The point that sees the missing segment at the largest angle, among the vertices of the
    // tetrahedra that the segment meets. If several do, the one with the least number.
    std::uint32_t reference() const noexcept { return reference_; }

  private:
    const double* vertex(VertexId v) const { return mesh_.point(v); }
    bool meets(const Tetrahedron& t, unsigned face, const double* a, const double* b) const;
    void consider(VertexId v, VertexId a, VertexId b);

    const Triangulation& triangulation_;
    const Mesh& mesh_;
    const Locator where_;
    VisitQueue star_, around_;
    std::uint32_t reference_ = no_index;
    double least_cosine_ = 0;
};

}  // namespace mgdt
