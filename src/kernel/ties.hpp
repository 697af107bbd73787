// SPDX-License-Identifier: MIT
// Conflicts that the filter of cached spheres leaves undecided. Arithmetic in doubles can still
// decide conflicts of points on a lattice, including ties, which are broken exactly. For other
// points, the predicates' own filter can decide, also for long and thin tetrahedra. Each island has
//
//   perturbed_doubles(t, vertices, query)
//
// which computes exact::perturbed_doubles() for a finite tetrahedron. The query point must not be a
// vertex of t.
#pragma once

#include "kernel/island.hpp"
#include "mesh/mesh.hpp"
#include "predicates/predicates.hpp"
#include MGDT_IN_ISLAND(ties.hpp)

namespace mgdt {
inline namespace MGDT_ISLAND {

// Whether q is in conflict with t; the result is that of is_conflict_exact().
MGDT_PREDICATES_APART inline bool is_conflict_near_tie(const Mesh& mesh, const Tetrahedron& t,
                                                       const Query& q) {
    if (t.is_ghost()) return is_conflict_exact(mesh, t, q.point);
    const Vertex* const vertices = mesh.vertices.data();
    int s = perturbed_doubles(t, vertices, q);
    if (MGDT_UNLIKELY(s == exact::undecided))
        s = exact::perturbed_integers(vertices[t.v[0]].x, vertices[t.v[1]].x, vertices[t.v[2]].x,
                                      vertices[t.v[3]].x, q.point);
    return s > 0;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
