// SPDX-License-Identifier: MIT
// The star of a vertex: all tetrahedra that have it, ghosts among them.
#pragma once

#include "mesh/star_traversal.hpp"
#include "query/locate.hpp"
#include "query/visit_queue.hpp"

namespace mgdt {

// Fills `star` with the tetrahedra of vertex v.
inline void gather_star(const Locator& where, VertexId v, VisitQueue& star) {
    star.clear();
    star.push(where.tetrahedron_of(v));
    traverse_star(where.mesh, v, star, [&](FacetCode facet) { star.push(tetrahedron_of(facet)); });
}

}  // namespace mgdt
