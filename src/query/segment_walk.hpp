// SPDX-License-Identifier: MIT
// The tetrahedra that a segment passes through.
#pragma once

#include "query/locate.hpp"

namespace mgdt {

// The tetrahedra that a segment from a to b passes through, in order: tetrahedron i is entered at
// a + parameters[i] (b - a) and left at a + parameters[i + 1] (b - a).
struct Traversal {
    explicit Traversal(Allocator& allocator) : tetrahedra(allocator), parameters(allocator) {}

    Buffer<TetId> tetrahedra;
    Buffer<double> parameters;  // none if there are no tetrahedra
};

// a and b are finite, in the caller's scale. If they are equal, the result is a tetrahedron that
// contains them, if there is one.
//
// Where the segment meets vertices or edges or runs in facets, the tetrahedra are those that it
// would pass through if it were displaced by an infinitesimal vector, without those that the
// segment itself meets in one point. See docs/theory.md, "Walks along a segment".
Traversal traverse_segment(const Locator& where, const double* a, const double* b,
                           Allocator& allocator);

}  // namespace mgdt
