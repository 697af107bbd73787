// SPDX-License-Identifier: MIT
// Conflicts that the filter of cached spheres leaves open, where doubles can still decide: on
// a lattice, whose ties they break exactly, and by the predicates' own filter, which holds for
// tetrahedra however long and thin. Each island has
//
//   perturbed_doubles(t, vertices, query)
//
// which is exact::perturbed_doubles() for a finite tetrahedron that the query is no vertex of.
#pragma once

#include "kernel/island.hpp"
#include "mesh/mesh.hpp"
#include "predicates/predicates.hpp"
#include MGDT_IN_ISLAND(ties.hpp)

namespace mgdt {
inline namespace MGDT_ISLAND {

// Whether q is in conflict with t, as is_conflict_exact() decides it.
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
